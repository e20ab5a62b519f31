// A rectangle of the window.
#pragma once

#include "core/shared/glue.h"

namespace plinian::window {

struct PaneRect {
  vec2 begin{0.0f}, size{0.0f};  // [points]
};

inline bool holds(const PaneRect& rect, vec2 at) {
  return at.x >= rect.begin.x && at.y >= rect.begin.y && at.x < rect.begin.x + rect.size.x &&
         at.y < rect.begin.y + rect.size.y;
}

/// What two have in common; of no size where that is nothing.
inline PaneRect common(const PaneRect& a, const PaneRect& b) {
  const vec2 begin = glm::max(a.begin, b.begin), end = glm::min(a.begin + a.size, b.begin + b.size);
  return {begin, glm::max(end - begin, vec2(0.0f))};
}

}  // namespace plinian::window
