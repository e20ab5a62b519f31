// What the panels have in common: the open scene, how it is looked at, and what they ask for.
//
// Panels never change the scene themselves. They ask for commands, which are run between two pictures of the
// interface, so that everything can be undone, is echoed in the console and could be typed there.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "host/scene/workspace.h"
#include "host/window/console/console_log.h"
#include "host/window/files/autosave.h"
#include "host/window/hotkeys/hotkeys.h"
#include "host/window/navigation/camera_history.h"
#include "host/window/platform/trace.h"
#include "host/window/view/developer.h"
#include "host/window/view/scene_feed.h"
#include "host/window/view/view_renderer.h"

namespace plinian::window {

/// What a running job says of itself, to be shown over the panels.
struct Job {
  std::string what;    // "reading smoke.vdb"; empty: none is running
  double share = 0.0;  // [0, 1]
  bool cancelled = false;
};

class Studio {
 public:
  /// wake: ends the wait of the interface's thread; called from any thread. trace_path: see Trace.
  Studio(std::function<void()> wake, const std::string& trace_path);
  ~Studio();

  // The scene.
  scene::Workspace workspace;
  SceneFeed feed;
  graph::Session& session() { return workspace.session(); }

  // How it is looked at.
  Look look;
  CameraHistory camera_history;
  Development development;
  bool original_maps = false;
  ivec2 picture_size{512};  // [pixels] of the picture at rest, as the viewport has room for it
  /// The camera that the viewport shows; needs a snapshot.
  Camera camera() const;
  /// The free camera, made of what is looked through where there is none yet.
  FreeCamera free_camera() const;
  /// Notes the camera for `[` and looks through `camera` from now on.
  void move_camera(const FreeCamera& camera, bool begins);
  void look_through_scene_camera();
  void frame_view(bool selection_only);

  // What makes pictures.
  ViewRenderer renderer;
  Developer developer;
  /// Asks for the picture of what is looked at now. hand_on: see ViewRequest.
  void update_picture();
  void keep_hand_on() { hand_on_until_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(180); }
  bool is_hand_on() const { return std::chrono::steady_clock::now() < hand_on_until_; }
  /// Whether the picture that is up is not yet of what is asked for.
  bool is_picture_old() const;

  // What it is compared with.
  Developer kept_developer;
  ViewPicturePtr kept;    // null: nothing
  std::string kept_name;  // "kept", "reference"
  bool wipes = false;
  float wipe = 0.5f;  // [-] of the picture's width: left of it the other one is seen
  /// Renders the offline reference of what is looked at, beside everything else.
  void render_reference();
  void stop_reference();
  /// How far that is [0, 1]; none where none is being rendered.
  std::optional<double> reference_share() const;
  /// Whether what it is compared with shows another scene or view by now.
  bool is_kept_old() const { return kept && kept->number != number_; }
  void keep_picture(ViewPicturePtr picture, const std::string& name);

  // What is asked for.
  /// Runs a command after this turn. merge_key: those of one drag share it. typed: show what it answers.
  void run(const std::string& line, const std::string& merge_key = "", bool typed = false);
  /// Ends a drag: what follows is another step of undo.
  void end_drag();
  void later(std::function<void()> task) { tasks_.push_back(std::move(task)); }
  /// Does what a key stands for.
  void act(Action action);
  /// Runs what was asked for.
  void work_off();
  bool has_work() const { return !tasks_.empty(); }

  /// A key for the commands of a new drag.
  std::string new_merge_key(const std::string& what);

  // Files. Each asks about unsaved changes where there are any.
  void open(const std::string& path);
  /// Adds a volume or a scene; a scene without media is framed and lit.
  void add_file(const std::string& path);
  /// What the program begins with: a scene, a volume or the name of a procedural medium.
  void begin_with(const std::string& input);

  // What is kept for after a crash.
  double autosave_seconds = 30.0;
  std::vector<Autosave::Left> left_behind;  // by programs that ended without order; to be asked about
  /// Keeps unsaved changes aside, where it is time.
  void autosave_if_due();
  void recover(const Autosave::Left& left);

  Hotkeys hotkeys;
  ConsoleLog console;
  Trace trace;
  Job job;
  /// Draws the interface while a job runs on its thread; set by the window.
  std::function<void()> draw_meanwhile;

  // What the panels tell one another.
  bool show_hotkeys = false, show_display = false, show_panels = true;
  bool light_key_held = false;  // the mouse turns the key light
  bool focus_console = false, wants_quit = false, quit = false;
  bool ask_open = false, ask_save_as = false;
  std::function<void()> after_unsaved;  // what waits for the answer about unsaved changes
  void unless_unsaved(std::function<void()> task);

 private:
  bool tell_progress(double share);
  void run_now(const std::string& line, const std::string& merge_key, bool typed);
  void import_whole(const std::string& input);

  std::function<void()> wake_;
  std::unique_ptr<ViewRenderer> reference_;
  std::vector<std::function<void()>> tasks_;
  std::string merge_key_;  // of the command that runs
  bool muted_ = false;     // commands are not echoed: they are told as one
  Autosave autosave_;
  std::chrono::steady_clock::time_point autosaved_ = std::chrono::steady_clock::now();
  std::uint64_t autosaved_generation_ = 0;
  std::uint64_t drags_ = 0;
  std::optional<SceneSnapshot> asked_;  // that a picture was asked for last
  std::uint64_t number_ = 0;
  std::chrono::steady_clock::time_point hand_on_until_{}, drawn_meanwhile_{};
};

}  // namespace plinian::window
