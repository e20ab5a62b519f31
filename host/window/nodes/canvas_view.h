// How a canvas is looked at: moved and zoomed.
#pragma once

#include "core/shared/glue.h"

namespace plinian::window {

struct CanvasView {
  vec2 offset{0.0f};  // [points of the window] of the canvas' origin from the pane's corner
  float zoom = 1.0f;  // [points of the window per point of the canvas]

  vec2 to_pane(vec2 canvas) const { return offset + canvas * zoom; }
  vec2 to_canvas(vec2 pane) const { return (pane - offset) / zoom; }
};

/// Zoomed by a factor, within what can be read, while the place under `pane` [points] stays. scale: the
/// interface's [-].
CanvasView zoomed(const CanvasView& view, vec2 pane, float factor, float scale);

/// Shows a rectangle of the canvas in the middle of a pane of that size; never larger than life.
CanvasView framed(vec2 begin, vec2 end, vec2 pane_size, float scale);

}  // namespace plinian::window
