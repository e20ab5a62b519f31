// The handles of the tool in hand, on what is selected: drawn, taken hold of, dragged.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "host/window/handles/handle_drag.h"
#include "host/window/handles/plugin_handles.h"
#include "host/window/studio.h"

namespace plinian::window {

class ViewportHandles {
 public:
  /// Draws them over the picture that is shown, and does what the mouse asks. begin, size: [points] where the
  /// picture is. free: the mouse is in the viewport, and nobody else's.
  void show(Studio& studio, const ViewPicture& picture, vec2 begin, vec2 size, bool free);
  /// Whether the mouse is theirs: on a handle, or holding one.
  bool is_taken() const { return hovered_ != Part::none || held_.has_value() || plugins_.is_taken(); }

 private:
  struct Held {
    explicit Held(HandleDrag drag_at_press) : drag(std::move(drag_at_press)) {}
    HandleDrag drag;
    HandleDrag::Result now;
    dvec2 mouse{0.0}, last{0.0};  // [points] slowed down while Shift is held; as it is
    std::string merge_key;
    std::uint64_t steps = 0;  // that the history had made
    bool snapped = false, moved = false;
  };
  void drag(Studio& studio);
  void let_go(Studio& studio, bool take_it_back);
  void take_hold(Studio& studio, HandleTarget target, const Projection& projection, double snap);

  Part hovered_ = Part::none;
  std::optional<Held> held_;
  PluginHandles plugins_;
};

}  // namespace plinian::window
