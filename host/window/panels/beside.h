// Where something opens that belongs to a row of a pane.
#pragma once

#include <algorithm>

#include "host/window/drawing/pane_rect.h"

namespace plinian::window {

/// Its corner: beside the pane, on the side of the window's middle, at the row's height, and within the
/// window. row: [points] the row's upper end. room: [points] of the window.
inline vec2 beside(const PaneRect& pane, float row, vec2 size, vec2 room, float gap) {
  const bool on_the_right = pane.begin.x + 0.5f * pane.size.x > 0.5f * room.x;
  const float x = on_the_right ? pane.begin.x - gap - size.x : pane.begin.x + pane.size.x + gap;
  return glm::max(glm::min(vec2(x, row), room - size), vec2(0.0f));
}

}  // namespace plinian::window
