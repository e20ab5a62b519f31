// Two ways to choose a zoom.
#include "host/window/nodes/canvas_view.h"

#include <algorithm>

namespace plinian::window {

namespace {

constexpr float smallest = 0.15f, largest = 2.5f;  // [-] of the interface's scale

}  // namespace

CanvasView zoomed(const CanvasView& view, vec2 pane, float factor, float scale) {
  CanvasView result = view;
  result.zoom = std::clamp(view.zoom * factor, smallest * scale, largest * scale);
  result.offset = pane - view.to_canvas(pane) * result.zoom;
  return result;
}

CanvasView framed(vec2 begin, vec2 end, vec2 pane_size, float scale) {
  constexpr float margin = 20.0f;  // [points of the canvas]
  const vec2 size = glm::max(end - begin + 2.0f * margin, vec2(1.0f));
  CanvasView result;
  result.zoom = std::clamp(std::min(pane_size.x / size.x, pane_size.y / size.y), smallest * scale, scale);
  result.offset = glm::floor(pane_size * 0.5f - (begin + end) * 0.5f * result.zoom);
  return result;
}

}  // namespace plinian::window
