// A small plot of curves over a common axis.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/shared/glue.h"

namespace plinian::window {

struct Curve {
  std::vector<dvec2> points;  // in order of x
  unsigned colour;            // as theme.h packs them
};

struct PlotMark {
  double x;
  unsigned colour;
  std::string label;
};

struct Plot {
  double x_low = 0.0, x_high = 1.0, y_high = 1.0;  // y begins at 0
  std::vector<Curve> curves;
  std::vector<PlotMark> marks;     // upright lines
  std::vector<double> thresholds;  // level lines
};

/// Draws a plot at the cursor, in the current window. size: [points]. Returns where on the x axis the mouse
/// holds it, if it does.
std::optional<double> show_plot(const char* id, const Plot& plot, vec2 size);

}  // namespace plinian::window
