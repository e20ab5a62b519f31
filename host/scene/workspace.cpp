// Puts a session together.
#include "host/scene/workspace.h"

#include "core/files/companion.h"
#include "host/graph/graph_error.h"
#include "host/scene/file_types.h"

namespace plinian::scene {

std::vector<std::filesystem::path> Workspace::plugin_folders() {
  try {
    return {companion_path({"plugins", "PLINIAN_PLUGINS", "the folder of plug-ins"})};
  } catch (const std::runtime_error&) {
    return {};  // a scene that needs one will say so
  }
}

Workspace::Workspace(std::vector<std::filesystem::path> folders) : plugins_(session_, std::move(folders)) {
  nodes::add_built_in(session_, plugins_);
  add_scene_importers(session_);
  add_camera_importers(session_);
  try {
    plugins_.load("atfm");
  } catch (const graph::GraphError&) {
    // Whoever needs it is told why it is not there.
  }
}

}  // namespace plinian::scene
