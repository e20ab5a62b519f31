// The fireball: a rolling ball of soot on a short stem, burning wherever its skin is torn.
#include <algorithm>
#include <cmath>

#include "core/media/procedural/kinds.h"
#include "core/media/procedural/noise.h"

namespace plinian::procedural {
namespace {

class Explosion final : public BillowShape {
 public:
  explicit Explosion(const ShapeSettings& settings) : BillowShape(settings) {
    family_ = found_family(compose());
    const LobeScale scale = [this](vec3 centre, vec3) {
      if (centre.y < -0.02f) return 0.0f;
      return 1.0f + 0.3f * gradient_noise(centre * 6.0f, settings_.seed + 5);
    };
    warp_reach = 0.045f;
    raise_family({{0.38f, 0.78f, 1.3f, 0.68f, 0.22f, 0.88f},
                  {0.26f, 0.62f, 1.6f, 0.64f, 0.12f, 0.84f},
                  {0.22f, 0.55f, 1.8f, 0.60f, -0.05f, 0.90f},
                  {0.22f, 0.50f, 1.5f, 0.60f, -0.25f, 0.95f}},
                 scale);

    warp_wavelength = 0.027f;
    hull_reach = 0.04f;
    surface_reach = std::max(0.01f, edge(1.0f / static_cast<float>(settings.resolution)));
    solid_depth = 0.06f;
  }

  vec3 warp(vec3 p) const override {
    return room(p, 0.1f) * (0.018f * gradient_noise3(p * 9.0f, settings_.seed + 11) +
                            0.006f * gradient_noise3(p * 36.0f, settings_.seed + 12));
  }

  bool shade(const BlockField& field, float* density, float* temperature) const override {
    fill_body(field, 0.35f, density);
    bool hot = false;
    for (int i = 0; i < BlockField::count; ++i) {
      if (density[i] <= 0.0f) continue;
      const vec3 p = field.position(i);
      // The skin has cooled from above; below and in its tears the fire shows.
      const float skin = 0.022f + 0.02f * p.y;
      const float torn = 0.6f * fractal_noise(p * 6.5f, 2, 0.5f, settings_.seed + 51);
      const float depth = smooth_step(1.4f, -1.0f, field.hull[i] / skin - 1.2f * torn);
      const float height = smooth_step(1.05f, 0.05f, p.y);
      const float kelvin = settings_.heat * 2300.0f * depth * (0.45f + 0.55f * height);
      if (kelvin < 550.0f) continue;
      temperature[i] = kelvin;
      hot = true;
    }
    return hot;
  }

 private:
  std::vector<Lobe> compose() const {
    RandomStream random(hash(settings_.seed, 0xe7u));
    std::vector<Lobe> puffs;
    const auto place = [&](vec3 p, float radius) {
      puffs.push_back({p + random.direction() * (0.15f * radius), radius * random.uniform(0.88f, 1.12f)});
    };
    const vec3 heart(0.5f, 0.46f, 0.5f);
    place(heart, 0.17f);
    place(heart + vec3(0.02f, 0.13f, 0.0f), 0.14f);
    const float turn = random.uniform(0.0f, 6.28f);
    // Balls over the whole fireball, the rolling ring under its waist the largest.
    for (int i = 0; i < 26; ++i) {
      const float z = 1.0f - 1.8f * (static_cast<float>(i) + 0.5f) / 26.0f;
      const float ring = std::sqrt(1.0f - z * z), angle = turn + 2.4f * static_cast<float>(i);
      const vec3 out(ring * std::cos(angle), z, ring * std::sin(angle));
      const float waist = smooth_step(0.9f, 0.0f, std::fabs(z + 0.15f));
      place(heart + out * vec3(0.19f + 0.05f * waist, 0.21f, 0.19f + 0.05f * waist) *
                        (settings_.spread * random.uniform(0.85f, 1.15f)),
            0.055f + 0.035f * waist + random.uniform(-0.01f, 0.015f));
    }
    // The stem, and the dust it kicks up.
    for (int i = 0; i < 5; ++i) {
      const float y = 0.055f * static_cast<float>(i);
      place({0.5f, y, 0.5f}, 0.062f + 0.008f * static_cast<float>(i % 2));
    }
    for (int i = 0; i < 34; ++i) {
      const float angle = turn + 2.4f * static_cast<float>(i),
                  share = std::sqrt((static_cast<float>(i) + 0.5f) / 34.0f);
      const float run = 0.21f + 0.04f * std::cos(3.0f * (angle - turn));
      place(vec3(0.5f, 0.0f, 0.5f) + vec3(std::cos(angle), 0, std::sin(angle)) * (share * run),
            0.042f - 0.022f * share);
    }
    return puffs;
  }
};

}  // namespace

std::unique_ptr<Shape> make_explosion(const ShapeSettings& settings) {
  return std::make_unique<Explosion>(settings);
}

}  // namespace plinian::procedural
