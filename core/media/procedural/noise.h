// Seeded hashes and gradient noise for the procedural media. Integer hashing only, so that a seed gives the
// same bytes on every machine and in every order of evaluation.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/shared/glue.h"

namespace plinian::procedural {

/// Avalanching 32-bit integer hash ("lowbias32", Wellons 2018).
inline std::uint32_t hash(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ (x >> 16);
}

inline std::uint32_t hash(std::uint32_t a, std::uint32_t b) {
  return hash(a ^ hash(b + 0x9e3779b9u));
}

/// The library's functions in double precision, rounded: their floats differ in the last bit from one
/// processor to another, and a lobe's place must not.
inline float cosine(float angle) {
  return static_cast<float>(std::cos(double(angle)));
}
inline float sine(float angle) {
  return static_cast<float>(std::sin(double(angle)));
}
inline float power(float base, float exponent) {
  return static_cast<float>(std::pow(double(base), double(exponent)));
}

/// A small stream of random numbers: a counter that is hashed. Streams of different keys are independent.
class RandomStream {
 public:
  explicit RandomStream(std::uint32_t key) : key_(hash(key ^ 0x5bd1e995u)) {}
  /// Uniform in [0, 1).
  float uniform() { return static_cast<float>(hash(key_ + 0x9e3779b9u * ++counter_) >> 8) * 0x1p-24f; }
  /// Uniform in [low, high).
  float uniform(float low, float high) { return low + (high - low) * uniform(); }
  /// Uniform on the unit sphere.
  vec3 direction() {
    const float z = uniform(-1.0f, 1.0f), angle = uniform(0.0f, 6.2831853f);
    const float r = std::sqrt(std::fmax(0.0f, 1.0f - z * z));
    return {r * cosine(angle), z, r * sine(angle)};
  }

 private:
  std::uint32_t key_, counter_ = 0;
};

/// Gradient noise on the unit lattice with quintic blending (Perlin 2002). Mean 0, range about [-1, 1], zero
/// at lattice points. p: [lattice cells], |p| < 2^30.
float gradient_noise(vec3 p, std::uint32_t seed);

/// Three independent gradient noises, for displacing positions.
inline vec3 gradient_noise3(vec3 p, std::uint32_t seed) {
  return {gradient_noise(p, seed), gradient_noise(p + vec3(31.4f, 47.2f, 11.7f), seed ^ 0x68bc21ebu),
          gradient_noise(p + vec3(-17.9f, 5.3f, 83.1f), seed ^ 0x02e5be93u)};
}

/// Sum of `octaves` gradient noises, each at twice the frequency (turned a little against the one before, so
/// that lattices do not line up) and `gain` times the amplitude. Divided by the sum of amplitudes.
float fractal_noise(vec3 p, int octaves, float gain, std::uint32_t seed);

/// Like fractal_noise with 1 - |noise| for each octave: thin bright ridges, in [0, 1].
float ridged_noise(vec3 p, int octaves, float gain, std::uint32_t seed);

/// Cubic step from 0 at `low` to 1 at `high`.
inline float smooth_step(float low, float high, float x) {
  const float t = std::fmin(std::fmax((x - low) / (high - low), 0.0f), 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace plinian::procedural
