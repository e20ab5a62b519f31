// Steps of scales that people read.
#pragma once

#include <algorithm>
#include <cmath>

namespace plinian {

/// The step of 1, 2 or 5 times a power of ten that cuts a range into four to ten parts. range: greater than
/// 0.
inline double tick_step(double range) {
  const double part = std::max(range, 1e-30) / 4.0;
  const double power = std::pow(10.0, std::floor(std::log10(part)));
  const double share = part / power;
  return power * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}

}  // namespace plinian
