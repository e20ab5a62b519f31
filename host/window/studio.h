// What the panels have in common: the open scene, how it is looked at, and what they ask for.
//
// Panels never change the scene themselves. They ask for commands, which are run between two pictures of the
// interface, so that everything can be undone, is echoed in the console and could be typed there.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/workspace.h"
#include "host/window/commands/command_queue.h"
#include "host/window/compare/comparison.h"
#include "host/window/compare/snapshots.h"
#include "host/window/console/console_log.h"
#include "host/window/console/news.h"
#include "host/window/files/file_browser.h"
#include "host/window/files/grid_lists.h"
#include "host/window/files/playblast.h"
#include "host/window/files/scene_files.h"
#include "host/window/handles/tool_choice.h"
#include "host/window/hotkeys/hotkeys.h"
#include "host/window/looks/look_pictures.h"
#include "host/window/navigation/viewpoint.h"
#include "host/window/overlay/overlay_choice.h"
#include "host/window/platform/trace.h"
#include "host/window/probe/inspector.h"
#include "host/window/view/developer.h"
#include "host/window/view/played_frames.h"
#include "host/window/view/scene_feed.h"
#include "host/window/view/view_renderer.h"

namespace plinian::window {

class Studio {
 public:
  /// wake: ends the wait of the interface's thread; called from any thread. trace_path: see Trace.
  Studio(std::function<void()> wake, const std::string& trace_path);

  Trace trace;
  ConsoleLog console;
  News news;  // of it
  Hotkeys hotkeys;

  // The scene.
  scene::Workspace workspace;
  SceneFeed feed;
  graph::Session& session() { return workspace.session(); }

  // What is asked for; see CommandQueue.
  CommandQueue commands;
  void run(const std::string& line, const std::string& merge_key = "") { commands.run(line, merge_key); }

  // How it is looked at.
  Viewpoint viewpoint;
  Development development;
  /// Of the configuration that $OCIO names; none before it has been read.
  const std::vector<OcioView>& ocio_views();
  OverlayChoice overlay;
  ToolChoice tools;
  bool original_maps = false;
  bool wants_light_maps = false;  // plug-ins draw over the picture
  ivec2 picture_size{512};        // [pixels] of the picture at rest, as the viewport has room for it

  // What makes pictures.
  ViewRenderer renderer;
  PlayedFrames played;
  bool is_playing = false;  // through time
  /// What is to be seen now: what the renderer has, or what was played before. Null before the first.
  ViewPicturePtr picture() const;
  /// Whether that shows what was asked for last, past its quick pass.
  bool is_picture_there();
  Developer developer;
  /// Asks for the picture of what is looked at now.
  void update_picture();
  void keep_hand_on() { hand_on_until_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(180); }
  bool is_hand_on() const { return std::chrono::steady_clock::now() < hand_on_until_; }

  // What it is compared with.
  Comparison comparison;
  Snapshots snapshots;
  bool wants_snapshot = false;  // as soon as there is a picture for it
  LookPictures looks;
  /// Renders the offline reference of what is looked at.
  void render_reference();
  /// Makes pictures of the scene that size [pixels], by commands.
  void set_gate(ivec2 size);
  /// Whether what it is compared with shows another scene or view by now.
  bool is_other_old() const { return comparison.is_old(number_) && comparison.is_old(subject_number_); }

  // What is looked into.
  Inspector inspector;

  SceneFiles files;
  GridLists grids;
  Playblast playblast;
  /// Returns why it cannot begin, one line; empty where it does.
  std::string start_playblast(const PlayblastSettings& settings);
  /// Tells the console how it ended. To be called once a turn.
  void update_playblast();

  // What the panels tell one another.
  bool show_hotkeys = false, show_display = false, show_panels = true;
  bool light_key_held = false;  // the mouse turns the key light
  bool zoom_key_held = false;   // the mouse pans the picture, the wheel magnifies it
  int zoom_steps = 0;           // that keys ask for; see PictureZoom
  bool focus_console = false, wants_quit = false, quit = false;
  bool ask_open = false, ask_save_as = false, ask_import = false, ask_reference = false, ask_plate = false;
  std::optional<FileWish> ask_file;  // of an attribute
  bool ask_playblast = false, show_snapshots = true, show_looks = false;
  bool show_nodes = false;    // beneath the picture, in place of the console
  bool show_palette = false;  // the command palette
  std::string typed_ahead;    // what the command line is to begin with, taken from here

 private:
  Take take();
  bool can_play_again() const;
  void keep_played();

  std::optional<SceneSnapshot> subject_;  // that a picture was asked for last, in its own light
  std::uint64_t number_ = 0;              // of that picture
  std::uint64_t subject_number_ = 0;      // of a picture of it in its own light
  std::uint64_t error_number_ = 0;        // ... and of its map error; 0: not asked for yet
  std::uint64_t numbers_ = 0;             // ever given
  std::uint64_t first_number_ = 1;        // of the take that is played
  ViewPicturePtr played_before_;          // of what was asked for; null: there is none
  // That was looked at last for what is played; it is not kept from going for that.
  std::weak_ptr<const ViewPicture> kept_;
  std::chrono::steady_clock::time_point hand_on_until_{};
  // A configuration may be large.
  std::future<std::vector<OcioView>> reading_ocio_ = std::async(std::launch::async, plinian::ocio_views);
  std::vector<OcioView> ocio_views_;
};

}  // namespace plinian::window
