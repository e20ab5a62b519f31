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

#include "core/scene/framing.h"
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
  std::string extent;                 // of the media; see extent_text(); empty where nothing is dense
};

/// Makes the nodes by commands, and fills in what the description leaves open (scale, camera, lights,
/// exposures), once for all frames of a sequence (sequence_setup.h): from its first frame with any density,
/// which becomes the current time. Throws std::runtime_error (one line), SceneLoadCancelled.
ImportReport import_description(graph::Session& session, const SceneDescription& description,
                                const ImportOptions& options = {});

/// A node name made of any name: what cannot stand in one becomes _.
std::string node_name_of(const std::string& name);

/// What a medium is called that comes of a file: "smoke" for "shots/smoke.####.vdb". A name, not yet free.
std::string medium_name_of(const std::string& path);

/// The name, else with the lowest number behind it by which neither a medium nor any node that belongs to it
/// is called yet. name_space: as in ImportOptions.
std::string free_medium_name(const graph::Graph& graph, const std::string& wanted,
                             const std::string& name_space = "");

/// How large something is and where its middle is: "2.1 x 3 x 2 m at (0, 1.5, 0)".
std::string extent_text(const SceneBounds& bounds);

}  // namespace plinian::scene
