// A curve over [0, 1] or any other range, drawn by a few points: what an artist edits as a ramp.
#pragma once

#include <vector>

#include "core/shared/glue.h"

namespace plinian::graph {

/// How a curve runs from a point to the next one.
enum class Interpolation {
  stepped,  // holds the point's value
  linear,
  smooth,  // monotone cubic: passes through the points and never overshoots them
};

struct RampPoint {
  float position = 0.0f;  // where on the ramp
  vec3 value{0.0f};       // three equal numbers where the ramp is of numbers
  Interpolation interpolation = Interpolation::linear;
  bool operator==(const RampPoint&) const = default;
};

/// Points in ascending order of position.
struct Ramp {
  std::vector<RampPoint> points;
  bool operator==(const Ramp&) const = default;
};

/// The ramp at a position; held constant before the first and behind the last point, 0 without points.
vec3 evaluate(const Ramp& ramp, float position);

/// Slopes of a monotone cubic Hermite curve through (x[i], y[i]), x ascending strictly
/// [Fritsch and Butland 1984: weighted harmonic means of the secants]; ends are flat.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y);

/// The monotone cubic Hermite curve between (x0, y0) with slope m0 and (x1, y1) with slope m1; in [y0, y1].
double hermite(double x0, double y0, double m0, double x1, double y1, double m1, double x);

}  // namespace plinian::graph
