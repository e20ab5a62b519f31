// A picture's texture in the current window, or the part of it that is seen.
#pragma once

#include <vector>

#include "host/window/drawing/pane_rect.h"

namespace plinian::window {

/// place: [points] where the whole picture is; polygon: the part of that, convex. upside_down: the texture
/// begins with its bottom row.
void add_image(unsigned texture, const PaneRect& place, const std::vector<vec2>& polygon,
               bool upside_down = false);
/// Its part in `room`.
void add_image(unsigned texture, const PaneRect& place, const PaneRect& room, bool upside_down = false);

}  // namespace plinian::window
