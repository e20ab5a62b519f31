// An open scene with all that comes with the program: node types, commands, plug-ins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/nodes/built_in.h"
#include "host/scene/snapshot.h"

namespace plinian::scene {

class Workspace {
 public:
  /// A new scene. Loads the plug-ins that come with the program, where they are there; more are found in
  /// $PLINIAN_PLUGIN_PATH and in `folders`.
  explicit Workspace(std::vector<std::filesystem::path> folders = plugin_folders());
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  graph::Session& session() { return session_; }
  sdk::PluginManager& plugins() { return plugins_; }
  SceneView& view() { return view_; }

  /// Where plug-ins are installed. Empty where there is no such folder.
  static std::vector<std::filesystem::path> plugin_folders();

 private:
  graph::Session session_;
  sdk::PluginManager plugins_;
  SceneView view_;
};

}  // namespace plinian::scene
