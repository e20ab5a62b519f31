// A scale and a shift.
#include "host/window/navigation/picture_zoom.h"

#include <algorithm>
#include <cmath>

namespace plinian::window {

float PictureZoom::factor() const {
  return std::exp2(0.5f * float(steps_));
}

PaneRect PictureZoom::magnified(const PaneRect& whole) const {
  if (!is_on()) return whole;
  const vec2 size = whole.size * factor();
  return {whole.begin + 0.5f * whole.size - centre_ * size, size};
}

// At 1 the picture lies where it fits; the further in, the nearer an edge may come to the middle.
void PictureZoom::look_at(vec2 centre) {
  const float reach = 0.5f * (1.0f - 1.0f / (factor() * factor()));
  centre_ = glm::clamp(centre, vec2(0.5f - reach), vec2(0.5f + reach));
}

void PictureZoom::step(int steps, vec2 at, const PaneRect& whole) {
  const PaneRect before = magnified(whole);
  const vec2 seen = (at - before.begin) / before.size;
  steps_ = std::clamp(steps_ + steps, 0, most_steps);
  look_at(seen - (at - (whole.begin + 0.5f * whole.size)) / (whole.size * factor()));
}

void PictureZoom::pan(vec2 centre, vec2 way, const PaneRect& whole) {
  look_at(centre - way / (whole.size * factor()));
}

}  // namespace plinian::window
