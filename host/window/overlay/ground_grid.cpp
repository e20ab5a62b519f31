// Lines between whole multiples of the spacing.
#include "host/window/overlay/ground_grid.h"

#include <cmath>

namespace plinian::window {

namespace {

constexpr int reach = 20;  // [cells] to each side
constexpr int piece = 2;   // [cells] of the same strength

}  // namespace

double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  // A hair of tolerance, so that 10^n is not taken for less by its logarithm.
  for (const double step : {10.0, 5.0, 2.0})
    if (step * power <= length * (1.0 + 1e-9)) return step * power;
  return power;
}

std::vector<GridLine> ground_grid(const dvec3& middle, double spacing) {
  std::vector<GridLine> lines;
  const double x0 = std::round(middle.x / spacing), z0 = std::round(middle.z / spacing);
  for (int across = -reach; across <= reach; ++across)
    for (int along = -reach; along < reach; along += piece) {
      const double centre = along + 0.5 * piece;
      const double far = std::sqrt(double(across) * across + centre * centre) / reach;
      if (far >= 1.0) continue;
      const float strength = float((1.0 - far) * (1.0 - far));
      const double x = (x0 + across) * spacing, z = (z0 + across) * spacing;
      lines.push_back({{x, 0.0, (z0 + along) * spacing},
                       {x, 0.0, (z0 + along + piece) * spacing},
                       strength,
                       x0 + across == 0.0});
      lines.push_back({{(x0 + along) * spacing, 0.0, z},
                       {(x0 + along + piece) * spacing, 0.0, z},
                       strength,
                       z0 + across == 0.0});
    }
  return lines;
}

}  // namespace plinian::window
