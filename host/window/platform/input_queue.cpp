// Decides where one picture's share of the input ends.
#include "host/window/platform/input_queue.h"

#include <GLFW/glfw3.h>

#include <set>
#include <utility>

namespace plinian::window {

namespace {

bool is_modifier(int key) {
  return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

// While one of these is down letters are no text: Dear ImGui drops what was typed in the same picture.
bool is_control(int key) {
  return key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL || key == GLFW_KEY_LEFT_SUPER ||
         key == GLFW_KEY_RIGHT_SUPER;
}

// What may change where keys go: Escape, Enter, Tab, arrows, chords. Letters and signs come in numbers.
bool is_of_consequence(const InputEvent& key) {
  constexpr int first_without_sign = GLFW_KEY_ESCAPE;
  return !is_modifier(key.code) && (key.code >= first_without_sign ||
                                    (key.modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)));
}

// What one picture has been told so far.
class Share {
 public:
  bool takes(const InputEvent& event) const {
    switch (event.kind) {
      case InputEvent::Kind::motion:
        return buttons_.empty() && !decided_;
      case InputEvent::Kind::button:
        return !buttons_.contains(event.code) && !wheeled_ && !decided_ && !kept_back_;
      case InputEvent::Kind::wheel:
        return buttons_.empty() && !decided_;
      case InputEvent::Kind::character:
        return buttons_.empty() && !decided_ && !control_;
      case InputEvent::Kind::key:
        break;
    }
    if (event.repeat) return true;
    if (!buttons_.empty()) return false;
    if (!event.down) return true;
    if (keys_.contains(event.code) || decided_) return false;
    if (is_control(event.code) && text_) return false;
    // Let go and pressed in one picture it would be held.
    if (is_of_consequence(event) && released_.contains(event.code)) return false;
    // Let go meanwhile, which this picture is not told.
    if (control_ && !is_modifier(event.code) && !(event.modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)))
      return false;
    return !is_of_consequence(event) || (!signs_ && !kept_back_);
  }

  void note(const InputEvent& event) {
    switch (event.kind) {
      case InputEvent::Kind::button:
        buttons_.insert(event.code);
        break;
      case InputEvent::Kind::wheel:
        wheeled_ = true;
        break;
      case InputEvent::Kind::key:
        if (!event.down) released_.insert(event.code);
        if (event.repeat || !event.down) break;
        keys_.insert(event.code);
        decided_ = is_of_consequence(event);
        control_ |= is_control(event.code);
        signs_ |= !is_modifier(event.code);
        break;
      case InputEvent::Kind::character:
        text_ = true;
        break;
      default:
        break;
    }
  }

  bool pressed(int key) const { return keys_.contains(key); }
  void keep_back() { kept_back_ = true; }

 private:
  std::set<int> buttons_, keys_, released_;  // that changed; were pressed, let go
  bool wheeled_ = false, signs_ = false, decided_ = false, kept_back_ = false;
  bool text_ = false, control_ = false;  // were typed; was pressed
};

}  // namespace

std::vector<InputEvent> InputQueue::take() {
  std::vector<InputEvent> taken = std::exchange(kept_back_, {});
  Share share;
  for (const InputEvent& event : taken) share.note(event);
  while (!waiting_.empty() && share.takes(waiting_.front())) {
    const InputEvent event = waiting_.front();
    waiting_.pop_front();
    if (event.kind == InputEvent::Kind::key && !event.down && share.pressed(event.code)) {
      kept_back_.push_back(event);
      share.keep_back();
      continue;
    }
    share.note(event);
    const bool moves_on = event.kind == InputEvent::Kind::motion && !taken.empty() &&
                          taken.back().kind == InputEvent::Kind::motion;
    if (moves_on)
      taken.back() = event;
    else
      taken.push_back(event);
  }
  return taken;
}

}  // namespace plinian::window
