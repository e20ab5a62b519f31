// A number over time, by keys: what an animation curve holds.
#pragma once

#include <vector>

#include "host/graph/values/ramp.h"

namespace plinian::graph {

struct AnimKey {
  double time = 0.0;  // [frames]
  double value = 0.0;
  Interpolation interpolation = Interpolation::smooth;  // to the next key
};

/// The curve through keys in any order; held before the first and behind the last one, 0 without keys.
double evaluate_keys(std::vector<AnimKey> keys, double time);

}  // namespace plinian::graph
