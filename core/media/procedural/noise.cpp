// Gradient noise and its sums over octaves.
#include "core/media/procedural/noise.h"

namespace plinian::procedural {
namespace {

/// Dot product of the offset with one of the twelve edge directions of a cube (four of them twice).
inline float gradient(std::uint32_t h, float x, float y, float z) {
  const std::uint32_t kind = h & 15u;
  const float u = kind < 8u ? x : y;
  const float v = kind < 4u ? y : (kind == 12u || kind == 14u ? x : z);
  return ((kind & 1u) ? -u : u) + ((kind & 2u) ? -v : v);
}

inline float fade(float t) {
  return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

inline float blend(float t, float a, float b) {
  return a + t * (b - a);
}

/// The next octave's lattice: doubled, and turned by about 30 degrees around a skew axis.
inline vec3 next_octave(vec3 p) {
  return {1.7320508f * p.x + 1.0f * p.y + 3.7f, -0.9397f * p.x + 1.6276f * p.y + 0.6840f * p.z - 5.1f,
          0.3420f * p.x - 0.5924f * p.y + 1.8794f * p.z + 9.2f};
}

template <class Shape>
float sum_octaves(vec3 p, int octaves, float gain, std::uint32_t seed, Shape shape) {
  float sum = 0.0f, total = 0.0f, amplitude = 1.0f;
  for (int i = 0; i < octaves; ++i) {
    sum += amplitude * shape(gradient_noise(p, seed + static_cast<std::uint32_t>(i)));
    total += amplitude;
    amplitude *= gain;
    p = next_octave(p);
  }
  return sum / total;
}

}  // namespace

float gradient_noise(vec3 p, std::uint32_t seed) {
  const float fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const float x = p.x - fx, y = p.y - fy, z = p.z - fz;
  const auto ix = static_cast<std::uint32_t>(static_cast<int>(fx));
  const auto iy = static_cast<std::uint32_t>(static_cast<int>(fy));
  const auto iz = static_cast<std::uint32_t>(static_cast<int>(fz));
  const std::uint32_t x0 = ix * 0x8da6b343u, x1 = x0 + 0x8da6b343u;
  const std::uint32_t y0 = iy * 0xd8163841u, y1 = y0 + 0xd8163841u;
  const std::uint32_t z0 = (iz * 0xcb1ab31fu) ^ (seed * 0x9e3779b9u);
  const std::uint32_t z1 = ((iz + 1u) * 0xcb1ab31fu) ^ (seed * 0x9e3779b9u);
  const auto corner = [](std::uint32_t h) {
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    return h >> 27;
  };
  const float u = fade(x), v = fade(y), w = fade(z);
  const float near = blend(
      v, blend(u, gradient(corner(x0 ^ y0 ^ z0), x, y, z), gradient(corner(x1 ^ y0 ^ z0), x - 1.0f, y, z)),
      blend(u, gradient(corner(x0 ^ y1 ^ z0), x, y - 1.0f, z),
            gradient(corner(x1 ^ y1 ^ z0), x - 1.0f, y - 1.0f, z)));
  const float far = blend(v,
                          blend(u, gradient(corner(x0 ^ y0 ^ z1), x, y, z - 1.0f),
                                gradient(corner(x1 ^ y0 ^ z1), x - 1.0f, y, z - 1.0f)),
                          blend(u, gradient(corner(x0 ^ y1 ^ z1), x, y - 1.0f, z - 1.0f),
                                gradient(corner(x1 ^ y1 ^ z1), x - 1.0f, y - 1.0f, z - 1.0f)));
  return blend(w, near, far);
}

float fractal_noise(vec3 p, int octaves, float gain, std::uint32_t seed) {
  return sum_octaves(p, octaves, gain, seed, [](float n) { return n; });
}

float ridged_noise(vec3 p, int octaves, float gain, std::uint32_t seed) {
  return sum_octaves(p, octaves, gain, seed, [](float n) { return 1.0f - std::fabs(n); });
}

}  // namespace plinian::procedural
