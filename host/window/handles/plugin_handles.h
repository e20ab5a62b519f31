// The handles that node types of plug-ins bring, on what was selected last.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/sdk/handles.h"
#include "host/window/overlay/projection.h"
#include "host/window/studio.h"

namespace plinian::window {

/// The camera of a picture that is shown from `begin` on in `size` [points], as handles of plug-ins see it:
/// pixels are points there, y up from the picture's lower edge. depth: [world] > 0 of what is looked at.
sdk::HandleView handle_view(const Camera& camera, int width, int height, vec2 size, double depth);

class PluginHandles {
 public:
  /// Draws them, and lets the mouse drag them. free: the mouse is in the viewport, and nobody else's.
  void show(Studio& studio, const ViewPicture& picture, vec2 begin, vec2 size, bool free);
  /// Whether one is under the mouse, or held.
  bool is_taken() const { return hovered_.has_value() || held_.has_value(); }
  bool is_held() const { return held_.has_value(); }

 private:
  struct Held {
    sdk::PlacedHandle handle;  // as it was when the mouse was pressed
    sdk::HandleView view;
    vec2 begin{0.0f}, size{0.0f};   // [points] of the picture then
    dvec2 pressed{0.0}, last{0.0};  // [pixels] of the view
    std::string merge_key, line;    // that was run last
    std::uint64_t steps = 0;        // that the history had made
  };
  void drag(Studio& studio);

  std::optional<std::size_t> hovered_;
  std::optional<Held> held_;
};

}  // namespace plinian::window
