#include "core/image/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plinian {
namespace {

constexpr std::array<std::uint32_t, 10> magma{0x000004, 0x180f3e, 0x451077, 0x721f81, 0x9f2f7f,
                                              0xcd4071, 0xf1605d, 0xfd9567, 0xfec98d, 0xfcfdbf};

vec3 anchor(std::size_t index) {
  const std::uint32_t code = magma[index];
  return vec3(float(code >> 16), float(code >> 8 & 255u), float(code & 255u)) / 255.0f;
}

}  // namespace

vec3 heat_colour(float value) {
  if (std::isnan(value)) return {0.0f, 1.0f, 1.0f};
  const float position = std::clamp(value, 0.0f, 1.0f) * float(magma.size() - 1);
  const std::size_t below = std::min(std::size_t(position), magma.size() - 2);
  return glm::mix(anchor(below), anchor(below + 1), position - float(below));
}

std::vector<std::uint8_t> heat_bytes(std::span<const float> values, float full_scale) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * values.size());
  for (const float value : values) {
    const vec3 colour = heat_colour(value / full_scale);
    for (int c = 0; c < 3; ++c) bytes.push_back(std::uint8_t(std::lround(255.0f * colour[c])));
  }
  return bytes;
}

float heat_full_scale(std::span<const float> values) {
  std::vector<float> sorted;
  for (const float value : values)
    if (std::isfinite(value)) sorted.push_back(value);
  if (sorted.empty()) return 1e-6f;
  const auto at = sorted.begin() + std::ptrdiff_t((sorted.size() - 1) * 999 / 1000);
  std::nth_element(sorted.begin(), at, sorted.end());
  const double wanted = std::max(double(*at), 1e-6);
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * decade >= wanted * (1.0 - 1e-6)) return float(step * decade);
  return float(10.0 * decade);
}

}  // namespace plinian
