// The window of the program: everything in it, until it is closed.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "core/shared/glue.h"

namespace plinian::window {

struct WindowOptions {
  std::string input = "ash";       // scene, volume or procedural medium to begin with; empty: an empty scene
  ivec2 size{1440, 900};           // [points]
  double autosave_seconds = 30.0;  // between two looks whether there is something to be kept
  const std::atomic<bool>* interrupted =
      nullptr;        // raised: the window ends and keeps what is not saved aside
  std::string trace;  // file to note in what happens, see Trace; empty: none
  /// Hears, once the window is closed, of a computation that goes on although it was asked to stop, in one
  /// line. The window waits for it for as long as it takes where this returns.
  std::function<void(const std::string& line)> on_no_end;
};

/// Opens the window and returns when it is closed. Throws NoDisplay (platform/desktop.h) where there is none.
void run_window(const WindowOptions& options);

/// Whether the environment names a display.
bool can_open_window();

}  // namespace plinian::window
