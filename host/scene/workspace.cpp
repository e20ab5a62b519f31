// Puts a session together.
#include "host/scene/workspace.h"

#include "core/files/companion.h"
#include "core/scene/resources.h"
#include "host/graph/graph_error.h"
#include "host/scene/file_types.h"
#include "host/scene/looks.h"
#include "host/scene/scene_commands.h"

namespace plinian::scene {

std::vector<std::filesystem::path> Workspace::plugin_folders() {
  std::vector<std::filesystem::path> folders;
  for (const std::filesystem::path& folder : search_folders()) folders.push_back(folder / "plugins");
  try {
    folders.push_back(companion_path({"plugins", "PLINIAN_PLUGINS", "the folder of plug-ins"}));
  } catch (const std::runtime_error&) {
    // A scene that needs one will say so.
  }
  return folders;
}

Workspace::Workspace(std::vector<std::filesystem::path> folders) : plugins_(session_, std::move(folders)) {
  nodes::add_built_in(session_, plugins_);
  add_scene_importers(session_);
  add_camera_importers(session_);
  add_preset_commands(*this);
  add_view_commands(*this);
  extend_parent_command(*this);
  add_reference_commands(*this);
  session_.add_listener(this);
  try {
    plugins_.load("atfm");
  } catch (const graph::GraphError&) {
    // Whoever needs it is told why it is not there.
  }
}

void Workspace::passed(graph::SceneMoment moment, const std::string&) {
  if (moment != graph::SceneMoment::after_open && moment != graph::SceneMoment::after_new) return;
  // What was looked at has gone; the quality set stays on.
  view_.camera = {};
  view_.isolated.clear();
  if (moment == graph::SceneMoment::after_open)
    for (const std::string& line : changed_looks(session_)) session_.warn(line);
}

}  // namespace plinian::scene
