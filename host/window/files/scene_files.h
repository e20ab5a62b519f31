// Opening, adding to, keeping aside and recovering the scene that is open.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/scene/workspace.h"
#include "host/window/commands/command_queue.h"
#include "host/window/files/autosave.h"
#include "host/window/files/recent_files.h"
#include "host/window/navigation/viewpoint.h"

namespace plinian::window {

class SceneFiles {
 public:
  SceneFiles(scene::Workspace& workspace, CommandQueue& commands, Viewpoint& viewpoint, ConsoleLog& console,
             Trace& trace);

  /// A scene or a volume in place of what is open; asks about unsaved changes where there are any. Else as
  /// add().
  void open(const std::string& path);
  void save_as(const std::string& path);
  /// Adds a volume; where there was none it is framed and lit, and it takes the place of a sample that the
  /// program began with. A scene is opened, a picture becomes the reference.
  void add(const std::string& path);
  /// What the program begins with: a scene, a volume or the name of a procedural medium.
  void begin_with(const std::string& input);
  /// A volume or a procedural medium in a scene of its own in place of what is open; asks about unsaved
  /// changes where there are any. What cannot be read changes nothing.
  void begin_anew(const std::string& input);
  /// An empty scene in place of the one that is open.
  void begin_empty();

  std::function<void()> after_unsaved;  // what waits for the answer about unsaved changes
  void unless_unsaved(std::function<void()> task);

  RecentFiles recent;

  // What is kept for after a crash.
  double autosave_seconds = 30.0;
  std::vector<Autosave::Left> left_behind;  // by programs that ended without order; to be asked about
  /// Keeps unsaved changes aside, where it is time and no hand is in the middle of something.
  void autosave_if_due(bool hand_on);
  /// Keeps unsaved changes aside for the next start: the program is told to end.
  void leave_unsaved();
  /// What is not saved is not wanted.
  void forget_unsaved() { autosave_.forget(); }
  void recover(const Autosave::Left& left);

  /// Frames everything, once what was added is there; set by the studio.
  std::function<void()> frame_all;

 private:
  void keep_unsaved();
  bool import_whole(const std::string& input);
  bool replace_by(const std::string& input);
  bool import_beside(const std::string& path);
  void select_medium();
  graph::Session& session() { return workspace_.session(); }

  scene::Workspace& workspace_;
  CommandQueue& commands_;
  Viewpoint& viewpoint_;
  ConsoleLog& console_;
  Trace& trace_;
  Autosave autosave_;
  std::chrono::steady_clock::time_point autosaved_ = std::chrono::steady_clock::now();
  std::uint64_t autosaved_generation_ = 0;
  bool is_sample_ = false;  // a procedural medium was begun with
};

}  // namespace plinian::window
