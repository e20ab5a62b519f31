// The window of the desktop, its OpenGL context and its input, through GLFW and Dear ImGui's backends for it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/shared/glue.h"
#include "host/window/hotkeys/hotkeys.h"
#include "host/window/platform/desktop.h"

namespace plinian::window {

class MainWindow {
 public:
  /// size: [points]. Throws NoDisplay. At most one at a time, while there is a Desktop.
  MainWindow(const std::string& title, ivec2 size);
  ~MainWindow();
  MainWindow(const MainWindow&) = delete;
  MainWindow& operator=(const MainWindow&) = delete;

  /// Waits for events, at most that long, and takes them. Returns whether there were any. seconds: 0 takes
  /// what is there.
  bool wait(double seconds);
  /// Hands the interface what of the input the next picture can tell apart; nothing, until the picture after
  /// the last call has begun.
  void tell_input();
  /// Whether there is more of it.
  bool has_input() const;
  /// Whether a key or a button was among what was told, which must be answered at once.
  bool take_urgent();
  /// The address of a GL function; null where there is none.
  static void* gl_function(const char* name);

  void begin_frame();
  /// Draws the interface over `background` and shows it.
  void end_frame(vec3 background);

  /// Whether its OpenGL context has gone, with all that was on the GPU; then another window is needed.
  bool is_context_lost() const;

  void set_title(const std::string& title);
  /// Off the screen, before it goes.
  void hide();
  /// The user asked to close it; taken back by asking.
  bool take_close_request();
  /// Files that were dropped on it since the last call, with where. [points]
  std::vector<std::string> take_dropped(dvec2* where = nullptr);
  /// Keys that were told of as pressed since the last call, in order.
  std::vector<Chord> take_keys();

  /// Whether a key is held down, and nothing beside it but what belongs to it or Shift, and not being typed
  /// into a field.
  bool is_held(const Chord& chord) const;

  ivec2 size() const;                                // [points]
  double pixel_ratio() const;                        // pixels per point, of what is drawn
  double interface_scale() const { return scale_; }  // of fonts and distances, as the desktop wants it

 private:
  struct Events;
  void* window_ = nullptr;
  std::unique_ptr<Events> events_;
  double scale_ = 1.0;
};

}  // namespace plinian::window
