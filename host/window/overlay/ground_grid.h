// The ground at height 0 and what lengths it has: a grid that fades with the distance, and a scale bar.
#pragma once

#include <vector>

#include "core/shared/glue.h"

namespace plinian::window {

/// 1, 2 or 5 times a power of ten: the largest that is not above `length`. [as length, > 0]
double round_length(double length);

struct GridLine {
  dvec3 from{0.0}, to{0.0};  // [world]
  float strength = 1.0f;     // [-] (0, 1]
  bool is_axis = false;      // through the origin
};

/// A grid whose cells are `spacing` [world], 20 of them to each side of what lies under `middle`, in pieces
/// that fade away from there.
std::vector<GridLine> ground_grid(const dvec3& middle, double spacing);

}  // namespace plinian::window
