// Where a picture lies in a place of another shape.
#pragma once

#include <algorithm>
#include <cmath>

#include "host/window/drawing/pane_rect.h"

namespace plinian::window {

/// In its own shape, as large as it can be, in the middle; the whole place where the shapes agree but for
/// the rounding to pixels. pixels: its sides, > 0.
inline PaneRect fitted(const PaneRect& place, vec2 pixels) {
  const vec2 room = place.size;
  if (std::abs(pixels.x * room.y - pixels.y * room.x) <= room.x + room.y) return place;
  const vec2 size = pixels * std::min(room.x / pixels.x, room.y / pixels.y);
  return {place.begin + (room - size) * 0.5f, size};
}

}  // namespace plinian::window
