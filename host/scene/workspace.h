// An open scene with all that comes with the program: node types, commands, plug-ins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/nodes/built_in.h"
#include "host/scene/snapshot.h"

namespace plinian::scene {

class Workspace : private graph::SessionListener {
 public:
  /// A new scene. Loads the plug-ins that come with the program, where they are there; more are found in
  /// $PLINIAN_PLUGIN_PATH and in `folders`. Tells of looks that changed when a scene is opened.
  explicit Workspace(std::vector<std::filesystem::path> folders = plugin_folders());
  ~Workspace() override { session_.remove_listener(this); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  graph::Session& session() { return session_; }
  sdk::PluginManager& plugins() { return plugins_; }
  SceneView& view() { return view_; }

  /// `plugins` in the folders of $PLINIAN_PATH, in the user's and where plug-ins are installed.
  static std::vector<std::filesystem::path> plugin_folders();

 private:
  void passed(graph::SceneMoment moment, const std::string& path) override;
  void begun() override {}
  void ended(bool) override {}

  graph::Session session_;
  sdk::PluginManager plugins_;
  SceneView view_;
};

}  // namespace plinian::scene
