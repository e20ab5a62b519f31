// A running estimate and a ladder of scales.
#include "host/window/view/interactive_cost.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plinian::window {

namespace {

constexpr std::array<double, 5> ladder = {0.25, 0.375, 0.5, 0.75, 1.0};

}  // namespace

ivec2 InteractiveCost::size(ivec2 pane) {
  if (ms_per_pixel_ > 0.0) {
    const double pixels = double(pane.x) * pane.y;
    const double wanted = std::sqrt(wanted_ms_ / (ms_per_pixel_ * pixels));
    double best = ladder.front();
    for (const double scale : ladder)
      // Going up needs a margin that going down does not.
      if (scale <= wanted * (scale > scale_ ? 0.85 : 1.0)) best = scale;
    scale_ = best;
  }
  const auto side = [&](int whole) {
    return std::clamp(int(std::lround(whole * scale_)), std::min(64, whole), whole);
  };
  return {side(pane.x), side(pane.y)};
}

void InteractiveCost::took(ivec2 size, double milliseconds) {
  const double now = milliseconds / std::max(1.0, double(size.x) * size.y);
  ms_per_pixel_ = ms_per_pixel_ > 0.0 ? 0.6 * ms_per_pixel_ + 0.4 * now : now;
}

}  // namespace plinian::window
