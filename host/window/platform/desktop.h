// The connection to the desktop, which outlives its windows: while there is one, other threads may wake
// whoever waits for events.
#pragma once

#include <stdexcept>
#include <string>

namespace plinian::window {

/// There is no display, or it has no OpenGL: one line that says what to do instead.
struct NoDisplay : std::runtime_error {
  explicit NoDisplay(const std::string& problem);
};

/// Whether the environment names a display.
bool has_display();

class Desktop {
 public:
  /// Throws NoDisplay. At most one at a time.
  Desktop();
  ~Desktop();
  Desktop(const Desktop&) = delete;
  Desktop& operator=(const Desktop&) = delete;

  /// Ends a wait for events from any thread; counts as an event.
  static void wake();
  /// Whether there was a call since the last one of this.
  static bool take_wake();
  /// What the desktop says of the last thing that went wrong.
  static std::string last_error();
};

}  // namespace plinian::window
