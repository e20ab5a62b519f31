#include "core/scene/rest_gauge.h"

#include <algorithm>
#include <cmath>

#include "core/shared/view_curve.h"

namespace plinian {
namespace {

constexpr float media_alpha = 0.01f;  // [-] pixels with less show no medium
constexpr double display_steps = 255.0;

float brightest_channel(vec3 v) {
  return glm::max(v.x, glm::max(v.y, v.z));
}

/// What lifts the picture until its 99.9th percentile is white; never less than one.
float lift(const std::vector<vec3>& picture) {
  std::vector<float> values(picture.size());
  std::transform(picture.begin(), picture.end(), values.begin(), brightest_channel);
  const auto at = values.begin() + std::ptrdiff_t(0.999 * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at > 0.0f ? glm::max(1.0f, 1.0f / *at) : 1.0f;
}

float display(float radiance) {
  return shared::srgb_from_linear(glm::clamp(radiance, 0.0f, 1.0f));
}

}  // namespace

bool RestGauge::looks_at(int passes) {
  while (passes > 3 && passes % 2 == 0) passes /= 2;
  return passes >= 1 && passes <= 3;
}

std::optional<float> RestGauge::look(int passes, const Frame& mean) {
  seen_[passes] = mean.beauty;
  const auto half = passes % 2 == 0 ? seen_.find(passes / 2) : seen_.end();
  std::optional<float> change;
  if (half != seen_.end()) {
    const float gain = lift(mean.beauty);
    double sum = 0.0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < mean.beauty.size(); ++i) {
      const vec3 t = mean.transmittance[i];
      if (1.0f - (t.x + t.y + t.z) / 3.0f <= media_alpha) continue;
      ++pixels;
      for (int c = 0; c < 3; ++c) {
        const double d = display(gain * mean.beauty[i][c]) - display(gain * half->second[i][c]);
        if (std::isfinite(d)) sum += d * d / 3.0;
      }
    }
    change = pixels > 0 ? float(display_steps * std::sqrt(sum / double(pixels))) : 0.0f;
  }
  // What is under half of this is never asked for again.
  std::erase_if(seen_, [&](const auto& entry) { return 2 * entry.first <= passes; });
  return change;
}

bool Refinement::wants_another(int done, const std::function<Frame()>& mean) {
  std::optional<float> change;
  if (passes_.on_mean) passes_.on_mean(done, mean);
  if (passes_.rest_change > 0.0f && RestGauge::looks_at(done)) change = gauge_.look(done, mean());
  if (change) change_ = change;
  const bool told_to_end = passes_.after_pass && !passes_.after_pass(done, change);
  return !told_to_end && done < passes_.most && !(change && *change <= passes_.rest_change);
}

}  // namespace plinian
