// The ash column: a narrow hot throat, buoyant bulges that widen as they rise, an umbrella that
// leans downwind, towards -x.
#include <algorithm>
#include <cmath>

#include "core/media/procedural/kinds.h"
#include "core/media/procedural/noise.h"

namespace plinian::procedural {
namespace {

struct Puff {
  float x, y, z, radius;  // [design] x and z from the column's axis
};

// The composition, from the throat to the dome: bulges alternate from side to side, with a pinch between
// them. Each bears the generations of lobes that are seen.
constexpr Puff column[] = {
    {0.000f, 0.000f, 0.000f, 0.044f},   {-0.004f, 0.045f, -0.004f, 0.034f}, {0.006f, 0.090f, 0.006f, 0.033f},
    {-0.010f, 0.135f, -0.010f, 0.038f}, {0.016f, 0.185f, 0.012f, 0.046f},   {-0.012f, 0.240f, 0.000f, 0.044f},
    {-0.030f, 0.285f, 0.014f, 0.055f},  {0.010f, 0.335f, 0.00f, 0.051f},    {0.036f, 0.385f, 0.020f, 0.064f},
    {-0.008f, 0.440f, -0.01f, 0.060f},  {-0.044f, 0.500f, 0.010f, 0.074f},  {0.004f, 0.555f, 0.00f, 0.074f},
    {0.052f, 0.620f, 0.015f, 0.088f},   {-0.042f, 0.660f, -0.01f, 0.092f},  {0.020f, 0.735f, 0.01f, 0.100f},
    {-0.068f, 0.750f, 0.010f, 0.084f},  {-0.010f, 0.815f, 0.000f, 0.066f},
};

class Ash final : public BillowShape {
 public:
  explicit Ash(const ShapeSettings& settings) : BillowShape(settings) {
    family_ = found_family(compose());
    const LobeScale scale = [this](vec3 centre, vec3 outward) {
      if (centre.y < -0.02f) return 0.0f;
      // Sizes drift from place to place; undersides, which have churned longest, are finer.
      return (1.0f + 0.25f * gradient_noise(centre * 7.0f, settings_.seed + 5)) *
             (outward.y < -0.4f ? 0.8f : 1.0f);
    };
    warp_reach = 0.035f;
    raise_family({{0.36f, 0.78f, 1.2f, 0.76f, 0.32f, 0.84f},
                  {0.24f, 0.60f, 1.5f, 0.68f, 0.18f, 0.78f},
                  {0.22f, 0.52f, 1.5f, 0.64f, 0.05f, 0.84f},
                  {0.22f, 0.50f, 1.5f, 0.60f, -0.15f, 0.92f}},
                 scale);

    warp_wavelength = 0.027f;
    hull_reach = 0.08f;
    surface_reach = std::max(0.01f, edge(1.0f / static_cast<float>(settings.resolution)));
    solid_depth = std::max(0.015f, surface_reach);
  }

  vec3 warp(vec3 p) const override {
    const float scale = (0.35f + 0.65f * std::min(1.0f, p.y * 1.4f)) * room(p, 0.1f);
    return scale * (0.014f * gradient_noise3(p * 11.0f, settings_.seed + 11) +
                    0.0045f * gradient_noise3(p * 36.0f, settings_.seed + 12));
  }

  bool shade(const BlockField& field, float* density, float* temperature) const override {
    fill_body(field, 0.3f, density);
    bool hot = false;
    for (int i = 0; i < BlockField::count; ++i) {
      const vec3 object = field.position(i);
      const vec3 p = fit_.design_from_object(object);
      if (field.hull[i] > 0.0f && density[i] < 0.1f)
        density[i] = std::max(density[i], veil(object, p, field.hull[i]));
      if (density[i] > 0.0f && p.y < 0.36f) hot |= heat(p, field.hull[i], temperature[i]);
    }
    return hot;
  }

 private:
  vec3 axis(float y) const { return {0.54f - settings_.lean * 0.09f * y * std::sqrt(y), y, 0.5f}; }

  std::vector<Lobe> compose() const {
    RandomStream random(hash(settings_.seed, 0xa5u));
    std::vector<Lobe> puffs;
    const auto place = [&](vec3 p, float radius) {
      puffs.push_back({p + random.direction() * (0.12f * radius), radius * random.uniform(0.93f, 1.07f)});
    };
    const auto around = [](float angle) { return vec3(cosine(angle), 0.0f, sine(angle)); };
    for (const Puff& puff : column) place(axis(puff.y) + vec3(puff.x, 0, puff.z), puff.radius);
    // The umbrella's rim, larger and farther out downwind.
    const float turn = random.uniform(0.0f, 6.28f);
    for (int i = 0; i < 8; ++i) {
      const float angle = turn + 0.7854f * static_cast<float>(i) + random.uniform(-0.25f, 0.25f);
      const float lee = 0.5f - 0.5f * cosine(angle);
      const float distance = settings_.spread * (0.17f + 0.07f * lee + random.uniform(-0.03f, 0.03f));
      const float y = 0.70f + random.uniform(-0.055f, 0.055f);
      place(axis(y) + around(angle) * distance, 0.056f + 0.028f * lee);
      place(axis(y) + around(angle) * (0.5f * distance), 0.080f);
    }
    // Young bulges that push out of the column's flanks.
    for (int i = 0; i < 6; ++i) {
      const float y = 0.17f + 0.075f * static_cast<float>(i) + random.uniform(-0.03f, 0.03f);
      const float angle = turn + 2.4f * static_cast<float>(i);
      place(axis(y) + around(angle) * (0.03f + 0.13f * y), 0.02f + 0.068f * y);
    }
    // Surges that run out along the ground, farther in three directions than between them.
    for (int i = 0; i < 48; ++i) {
      const float angle = turn + 2.4f * static_cast<float>(i) + random.uniform(-0.15f, 0.15f);
      const float run = 0.085f + 0.035f * cosine(3.0f * (angle - turn)) - 0.02f * cosine(angle);
      const float share = std::sqrt((static_cast<float>(i) + 0.5f) / 48.0f);
      place(axis(0.0f) + around(angle) * (0.03f + share * run),
            0.018f - 0.010f * share + random.uniform(-0.003f, 0.006f));
    }
    return puffs;
  }

  /// Hot where the cooled skin of the lobes is thin: in their crevices, low in the column, near its axis.
  bool heat(vec3 p, float hull, float& kelvin) const {
    const vec3 from_axis = p - axis(p.y);
    const float away = std::sqrt(from_axis.x * from_axis.x + from_axis.z * from_axis.z);
    const float skin = 0.006f + 0.03f * p.y;
    const float crevice = smooth_step(1.2f, -0.4f, hull / skin);
    const float low = smooth_step(0.36f, 0.02f, p.y) * smooth_step(0.095f, 0.035f, away - 0.25f * p.y);
    const float value = settings_.heat * 1900.0f * std::sqrt(low) * (0.2f + 0.8f * crevice);
    if (value < 500.0f) return false;  // glows no more
    kelvin = value;
    return true;
  }

  /// Thin ash outside the hull: dust along the ground, and shreds that the wind tears off the lee side.
  float veil(vec3 object, vec3 p, float distance) const {
    const float ground = smooth_step(0.06f, 0.0f, p.y);
    const float lee = smooth_step(0.42f, 0.58f, p.y) * smooth_step(-0.08f, 0.12f, axis(p.y).x - p.x);
    const float mask = smooth_step(hull_reach, 0.0f, distance) * room(object, 0.04f) * std::max(ground, lee);
    if (mask < 0.02f) return 0.0f;
    // Drawn out downwind, and sheared: shreds, not puffs.
    const vec3 q = p + 0.035f * gradient_noise3(p * 7.0f, settings_.seed + 31);
    const float ridges = ridged_noise(q * vec3(7, 19, 13), 3, 0.6f, settings_.seed + 32);
    const float value = settings_.veils * 0.02f * mask * smooth_step(0.95f - 0.45f * mask, 1.0f, ridges);
    return value > 0.0005f ? value : 0.0f;
  }
};

}  // namespace

std::unique_ptr<Shape> make_ash(const ShapeSettings& settings) {
  return std::make_unique<Ash>(settings);
}

}  // namespace plinian::procedural
