// What is lost, and what it costs not to lose it.
#include "host/window/view/interactive_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace plinian::window {

namespace {

constexpr std::array scales = {0.25, 0.3125, 0.375, 0.4375, 0.5, 0.625, 0.75, 1.0};
constexpr std::array steps = {64, 96, 128, 160, 192, 256, 384, 512, 768, 1024, 2048, 4096, 8192};

// 1 - SSIM against the picture at rest, scaled up, as measured on ash of 256^3 at 512^2, where both add up.
double loss_of_view(double scale) {
  return 0.0028 * std::pow(scale, -2.2);
}
double loss_of_maps(int resolution) {
  return 0.00058 * std::pow(resolution / 512.0, -3.0);
}
// [1/ms] What a millisecond counts beside that: a hand would rather have twenty pictures a second than ten
// that are hardly better. Where even the smallest pictures come late it counts more.
constexpr double loss_of_time = 0.0003, loss_of_late_time = 0.002;

}  // namespace

void InteractiveCost::Recent::add(double value) {
  values_[count_++ % values_.size()] = value;
}

double InteractiveCost::Recent::middle() const {
  if (count_ == 0) return 0.0;
  std::array<double, 5> sorted = values_;
  const std::size_t known = std::min(count_, sorted.size());
  std::sort(sorted.begin(), sorted.begin() + std::ptrdiff_t(known));
  return sorted[(known - 1) / 2];
}

InteractiveCost::Choice InteractiveCost::choose(ivec2 pane, int full, int builds) {
  const double per_pixel = ms_per_pixel_.middle(), per_texel = ms_per_texel_.middle();
  last_.resolution = std::min(last_.resolution, full);
  if (per_pixel == 0.0 || (builds > 0 && per_texel == 0.0)) return last_;

  const auto cost = [&](const Choice& choice) {
    const ivec2 pixels = size(pane, choice.scale);
    return per_pixel * pixels.x * pixels.y +
           per_texel * builds * double(choice.resolution) * choice.resolution;
  };
  const auto loss = [&](const Choice& choice, double of_time = loss_of_time) {
    return loss_of_view(choice.scale) + (builds > 0 ? loss_of_maps(choice.resolution) : 0.0) +
           of_time * cost(choice);
  };
  std::optional<Choice> best, late;
  const auto consider = [&](const Choice& choice) {
    if (!late || loss(choice, loss_of_late_time) < loss(*late, loss_of_late_time)) late = choice;
    // Going up needs a margin that staying does not.
    if (cost(choice) <= 0.9 * limit_ms_ && (!best || loss(choice) < loss(*best))) best = choice;
  };
  for (const double scale : scales) {
    if (builds == 0) {
      consider({scale, last_.resolution});
      continue;
    }
    for (const int step : steps)
      if (step < full) consider({scale, step});
    consider({scale, full});
  }
  if (!best) best = late;
  const bool same_kind = last_builds_ == (builds > 0);
  if (!(same_kind && cost(last_) <= limit_ms_ && loss(last_) < 1.15 * loss(*best))) last_ = *best;
  last_builds_ = builds > 0;
  return last_;
}

ivec2 InteractiveCost::size(ivec2 pane, double scale) {
  const auto side = [&](int whole) {
    return std::clamp(int(std::lround(whole * scale)), std::min(64, whole), whole);
  };
  return {side(pane.x), side(pane.y)};
}

void InteractiveCost::took_view(ivec2 size, double milliseconds) {
  ms_per_pixel_.add(milliseconds / std::max(1.0, double(size.x) * size.y));
}

void InteractiveCost::took_maps(int resolution, int builds, double milliseconds) {
  if (builds > 0) ms_per_texel_.add(milliseconds / (double(builds) * resolution * resolution));
}

}  // namespace plinian::window
