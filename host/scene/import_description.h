// The nodes that a neutral scene, a volume or a procedural name stands for.
//
// For a medium called NAME (`medium` where it has no name): NAME (medium), NAME_place (transform), NAME_shape
// (atfmVolume) and NAME_file (volumeRead) or NAME_noise (volumeNoise). Lights and the camera are called as
// the description calls them; `settings` is the renderSettings, `sky` the ambientLight.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene_description.h"
#include "host/graph/commands/session.h"

namespace plinian::scene {

struct ImportOptions {
  double vdb_time_limit_s = 0.0;             // [s] for reading one file; 0: grows with the file
  std::uint64_t vdb_memory_limit_bytes = 0;  // for reading one file; 0: grows with the file
  std::function<bool(double)> progress;      // called with a share in [0, 1]; returning false cancels
  std::string name_space;                    // goes before the names of the nodes, with a colon
  bool media_only = false;                   // neither camera, lights nor settings
  /// Called once all nodes are there and nothing was read: the place to refuse what cannot be.
  std::function<void()> nodes_made;
};

struct ImportReport {
  std::vector<std::string> notes;     // what was assumed or chosen, one line each
  std::vector<std::string> warnings;  // what was mended, one line each
  std::optional<int> seed;            // of the first procedural medium
  std::vector<std::string> nodes;     // that were made
  std::string extent;                 // see extent_text(); of media alone, else the camera tells it
};

/// Makes the nodes by commands, and fills in what the description leaves open (scale, camera, lights,
/// exposures), once for all frames of a sequence (sequence_setup.h): from its first frame with any density,
/// which becomes the current time. Throws std::runtime_error (one line), SceneLoadCancelled.
ImportReport import_description(graph::Session& session, const SceneDescription& description,
                                const ImportOptions& options = {});

}  // namespace plinian::scene
