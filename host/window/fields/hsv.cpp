// The hexcone of [Smith 1978].
#include "host/window/fields/hsv.h"

#include <algorithm>
#include <cmath>

#include "core/shared/view_curve.h"

namespace plinian::window {

Hsv hsv_of(const vec3& linear, const Hsv& before) {
  vec3 c;
  for (int i = 0; i < 3; ++i) c[i] = shared::srgb_from_linear(std::max(linear[i], 0.0f));
  const float most = std::max({c.x, c.y, c.z}), least = std::min({c.x, c.y, c.z}), span = most - least;
  Hsv hsv = before;
  hsv.value = most;
  if (!(most > 0.0f)) return hsv;
  hsv.saturation = span / most;
  // Below that it is the rounding of a grey.
  if (span < 1e-5f * most) {
    hsv.saturation = 0.0f;
    return hsv;
  }
  const float sixth = most == c.x   ? (c.y - c.z) / span
                      : most == c.y ? 2.0f + (c.z - c.x) / span
                                    : 4.0f + (c.x - c.y) / span;
  hsv.hue = 60.0f * (sixth < 0.0f ? sixth + 6.0f : sixth);
  return hsv;
}

vec3 linear_of(const Hsv& hsv) {
  const float turns = hsv.hue / 360.0f, sixth = 6.0f * (turns - std::floor(turns));
  vec3 linear;
  for (int i = 0; i < 3; ++i) {
    // Of red, green and blue how far the hue is from where that one is strongest.
    const float away = std::abs(sixth - 2.0f * float(i)), from = std::min(away, 6.0f - away);
    const float share = 1.0f - hsv.saturation * std::clamp(from - 1.0f, 0.0f, 1.0f);
    linear[i] = shared::linear_from_srgb(hsv.value * share);
  }
  return linear;
}

}  // namespace plinian::window
