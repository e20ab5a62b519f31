// What hands do, told a picture of the interface at a time and never more at once than it can tell apart.
//
// Dear ImGui 1.86 sees mouse and keys as they are when a picture begins. Where pictures take their time, a
// key that is let go of before then would not have been pressed, a click that the mouse has left already
// would land elsewhere, and Enter behind Escape would come first.
#pragma once

#include <deque>
#include <vector>

#include "core/shared/glue.h"

namespace plinian::window {

struct InputEvent {
  enum class Kind { motion, button, wheel, key, character };
  Kind kind = Kind::motion;
  int code = 0;         // of a button or a key (GLFW's); of a character, Unicode
  bool down = false;    // pressed, not let go
  bool repeat = false;  // pressed a while ago, and still held
  int scancode = 0, modifiers = 0;
  dvec2 at{0.0};  // motion: where to [points]; wheel: how far
};

class InputQueue {
 public:
  void add(const InputEvent& event) { waiting_.push_back(event); }
  bool is_empty() const { return waiting_.empty() && kept_back_.empty(); }
  /// The next ones, in order, for one picture. A key that was pressed and let go within them is let go of
  /// with the next. Of motions in a row the last one stands for all.
  std::vector<InputEvent> take();

 private:
  std::deque<InputEvent> waiting_;
  std::vector<InputEvent> kept_back_;  // keys let go of, told as pressed with the last picture
};

}  // namespace plinian::window
