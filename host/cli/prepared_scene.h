// From the arguments of a command to a scene in a graph, and to the snapshots that it gives.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/cli/scene_arguments.h"
#include "host/scene/workspace.h"

namespace plinian::cli {

struct PreparedScene {
  std::unique_ptr<scene::Workspace> workspace;
  SceneSnapshot snapshot;                    // as it was prepared
  std::vector<std::string> notes, warnings;  // that were said aloud
  std::optional<int> seed;                   // of the first procedural medium of an input that is no scene
  double load_ms = 0.0;                      // wall clock
};

/// Whether a scene is prepared with a snapshot of the moment that is on.
enum class FirstSnapshot { taken, left_out };

/// Opens a scene, or makes the nodes that the input stands for; applies --set and the like, reads what the
/// picture needs, and says aloud what was assumed. Throws std::runtime_error, SceneLoadCancelled.
PreparedScene prepare_scene(const SceneArguments& arguments, FirstSnapshot first = FirstSnapshot::taken);

/// The snapshot of the scene as it is now. Says aloud what is shown in place of what is missing. Throws
/// std::runtime_error where a shape fails, SceneLoadCancelled.
SceneSnapshot take_snapshot(PreparedScene& scene);

/// Says which frame of each sequence the scene shows now, where only one is to be a picture.
void tell_shown_frames(PreparedScene& scene);

/// Sets NODE.ATTRIBUTE, or a key of the quality set that is on. value: numbers may be separated by commas.
/// Throws std::runtime_error.
void apply_edit(scene::Workspace& workspace, const SceneEdit& edit);

}  // namespace plinian::cli
