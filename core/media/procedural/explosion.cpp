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
    raise_family({{0.38f, 0.78f, 1.2f, 0.76f, 0.32f, 0.84f},
                  {0.24f, 0.60f, 1.5f, 0.68f, 0.18f, 0.76f},
                  {0.22f, 0.52f, 1.5f, 0.64f, 0.05f, 0.84f},
                  {0.22f, 0.50f, 1.5f, 0.60f, -0.15f, 0.92f}},
                 scale);

    warp_wavelength = 0.027f;
    hull_reach = 0.085f;  // heat reaches 1.5 skins out
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
      // The skin has cooled, from above first; in its crevices and tears and under its belly the fire shows.
      const vec3 design = fit_.design_from_object(p);
      const float torn = fractal_noise(p * 5.0f, 3, 0.55f, settings_.seed + 51);
      const float belly = smooth_step(0.75f, 0.25f, design.y);
      const float skin = std::clamp(0.022f + 0.022f * belly + 0.06f * torn, 0.006f, 0.055f);
      const float depth = smooth_step(1.5f, -0.3f, field.hull[i] / skin);
      const float away = glm::length(design - vec3(0.5f, design.y, 0.5f));  // from the stem's axis
      const float dust = smooth_step(0.15f, 0.08f, design.y) * smooth_step(0.06f, 0.11f, away);
      const float kelvin = settings_.heat * 2250.0f * depth * (0.78f + 0.22f * belly) * (1.0f - dust);
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
    const vec3 heart(0.5f, 0.50f, 0.5f);
    place(heart, 0.15f);
    place(heart + vec3(0.02f, 0.13f, 0.0f), 0.11f);
    const float turn = random.uniform(0.0f, 6.28f);
    // Balls over the whole fireball; the ring that rolls around its waist is the largest.
    for (int i = 0; i < 24; ++i) {
      const float z = 1.0f - 1.75f * (static_cast<float>(i) + 0.5f) / 24.0f;
      const float ring = std::sqrt(1.0f - z * z), angle = turn + 2.4f * static_cast<float>(i);
      const float waist = smooth_step(0.9f, 0.0f, std::fabs(z + 0.1f));
      const vec3 reach = settings_.spread * vec3(0.17f + 0.06f * waist, 0.20f, 0.17f + 0.06f * waist);
      place(heart + vec3(ring * cosine(angle), z, ring * sine(angle)) * reach * random.uniform(0.8f, 1.2f),
            0.045f + 0.035f * waist + random.uniform(-0.01f, 0.015f));
    }
    // The stem, and the dust that runs out from its foot.
    for (int i = 0; i < 7; ++i) {
      const float y = 0.05f * static_cast<float>(i);
      place({0.5f, y, 0.5f}, 0.045f + 0.006f * static_cast<float>(i));
    }
    for (int i = 0; i < 60; ++i) {
      const float angle = turn + 2.4f * static_cast<float>(i);
      const float share = std::sqrt((static_cast<float>(i) + 0.5f) / 60.0f);
      const float run = 0.24f + 0.05f * cosine(3.0f * (angle - turn));
      place(vec3(0.5f, 0.0f, 0.5f) + vec3(cosine(angle), 0, sine(angle)) * (share * run),
            0.028f - 0.010f * share + random.uniform(-0.004f, 0.006f));
    }
    return puffs;
  }
};

}  // namespace

std::unique_ptr<Shape> make_explosion(const ShapeSettings& settings) {
  return std::make_unique<Explosion>(settings);
}

}  // namespace plinian::procedural
