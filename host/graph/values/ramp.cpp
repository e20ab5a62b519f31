// Ramps and the monotone cubic that ramps and animation curves share.
#include "host/graph/values/ramp.h"

#include <algorithm>

namespace plinian::graph {

std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> slopes(x.size(), 0.0);
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
    const double before = (y[i] - y[i - 1]) / left, after = (y[i + 1] - y[i]) / right;
    if (before * after <= 0.0) continue;  // a peak or a plateau: flat
    const double w1 = 2.0 * right + left, w2 = right + 2.0 * left;
    slopes[i] = (w1 + w2) / (w1 / before + w2 / after);
  }
  return slopes;
}

double hermite(double x0, double y0, double m0, double x1, double y1, double m1, double x) {
  const double width = x1 - x0, t = (x - x0) / width, t2 = t * t, t3 = t2 * t;
  const double y = (2.0 * t3 - 3.0 * t2 + 1.0) * y0 + (t3 - 2.0 * t2 + t) * width * m0 +
                   (3.0 * t2 - 2.0 * t3) * y1 + (t3 - t2) * width * m1;
  return std::clamp(y, std::min(y0, y1), std::max(y0, y1));
}

vec3 evaluate(const Ramp& ramp, float position) {
  const auto& points = ramp.points;
  if (points.empty()) return vec3(0.0f);
  const auto next = std::upper_bound(points.begin(), points.end(), position,
                                     [](float x, const RampPoint& point) { return x < point.position; });
  if (next == points.begin()) return points.front().value;
  if (next == points.end()) return points.back().value;
  const RampPoint &from = *(next - 1), &to = *next;
  if (from.interpolation == Interpolation::stepped) return from.value;
  const float t = (position - from.position) / (to.position - from.position);
  if (from.interpolation == Interpolation::linear) return from.value + t * (to.value - from.value);
  std::vector<double> x, y(points.size());
  for (const RampPoint& point : points) x.push_back(point.position);
  vec3 result(0.0f);
  const std::size_t i = std::size_t(next - points.begin()) - 1;
  for (int channel = 0; channel < 3; ++channel) {
    for (std::size_t k = 0; k < points.size(); ++k) y[k] = points[k].value[channel];
    const std::vector<double> m = monotone_slopes(x, y);
    result[channel] = float(hermite(x[i], y[i], m[i], x[i + 1], y[i + 1], m[i + 1], position));
  }
  return result;
}

}  // namespace plinian::graph
