// The haboob: a wall of dust that rolls towards +z, lobe over lobe, its nose near the ground and its crest
// trailing behind.
#include <algorithm>
#include <cmath>

#include "core/media/procedural/kinds.h"
#include "core/media/procedural/noise.h"

namespace plinian::procedural {
namespace {

class Sandstorm final : public BillowShape {
 public:
  explicit Sandstorm(const ShapeSettings& settings) : BillowShape(settings) {
    family_ = found_family(compose());
    const LobeScale scale = [this](vec3 centre, vec3 outward) {
      if (centre.y < -0.03f) return 0.0f;
      return (1.0f + 0.35f * gradient_noise(centre * 6.0f, settings_.seed + 5)) *
             (outward.z < -0.3f ? 0.7f : 1.0f);
    };
    warp_reach = 0.035f;
    raise_family({{0.36f, 0.75f, 1.4f, 0.66f, 0.20f, 0.90f},
                  {0.26f, 0.62f, 1.7f, 0.62f, 0.10f, 0.86f},
                  {0.22f, 0.55f, 1.8f, 0.60f, -0.05f, 0.90f},
                  {0.22f, 0.50f, 1.5f, 0.60f, -0.25f, 0.95f}},
                 scale);

    warp_wavelength = 0.027f;
    hull_reach = 0.07f;
    surface_reach = std::max(0.01f, edge(1.0f / static_cast<float>(settings.resolution)));
    solid_depth = 0.03f;
  }

  vec3 warp(vec3 p) const override {
    return room(p, 0.1f) * (0.014f * gradient_noise3(p * 10.0f, settings_.seed + 11) +
                            0.005f * gradient_noise3(p * 36.0f, settings_.seed + 12));
  }

  bool shade(const BlockField& field, float* density, float*) const override {
    fill_body(field, 0.4f, density);
    for (int i = 0; i < BlockField::count; ++i) {
      const vec3 p = field.position(i);
      if (field.hull[i] > 0.0f && density[i] < 0.1f)
        density[i] = std::max(density[i], dust(p, field.hull[i]));
    }
    return false;
  }

 private:
  std::vector<Lobe> compose() const {
    RandomStream random(hash(settings_.seed, 0x5du));
    std::vector<Lobe> puffs;
    const auto place = [&](vec3 p, float radius) {
      puffs.push_back({p + random.direction() * (0.2f * radius), radius * random.uniform(0.85f, 1.15f)});
    };
    const float phase = random.uniform(0.0f, 6.28f);
    for (int i = 0; i < 15; ++i) {
      const float x = 0.06f + 0.88f * static_cast<float>(i) / 14.0f;
      const float side = std::fabs(x - 0.5f) * 2.0f;
      // The front bends back at the ends and bulges in between.
      const float front = 0.68f - 0.10f * side * side + 0.05f * std::sin(9.0f * x + phase);
      const float height =
          0.30f * (1.0f - 0.35f * side * side) * (1.0f + 0.22f * std::sin(7.0f * x + 2.0f * phase));
      for (int row = 0; row < 4; ++row) {
        const float up = (static_cast<float>(row) + 0.3f) / 4.0f;
        const float nose = 0.05f * settings_.lean * std::sin(3.0f * (up + 0.15f));
        const float radius = 0.052f + 0.012f * (1.0f - up);
        place({x, up * height, front + nose - 0.10f * up}, radius);
      }
      // The body behind, sinking away from the crest.
      for (int row = 0; row < 4; ++row) {
        const float back = 0.07f + 0.085f * static_cast<float>(row);
        const float top = height * (0.75f - 0.13f * static_cast<float>(row));
        place({x, top, front - back}, 0.055f);
        place({x, 0.5f * top, front - back}, 0.06f);
        place({x, 0.0f, front - back}, 0.06f);
      }
    }
    return puffs;
  }

  /// Dust that blows off the crest, and that runs ahead along the ground.
  float dust(vec3 p, float distance) const {
    const float crest = smooth_step(0.15f, 0.3f, p.y), ground = 0.8f * smooth_step(0.05f, 0.0f, p.y);
    const float mask = smooth_step(hull_reach, 0.0f, distance) * room(p, 0.04f) * std::max(crest, ground);
    if (mask < 0.02f) return 0.0f;
    const vec3 q = p + 0.03f * gradient_noise3(p * 8.0f, settings_.seed + 31);
    const float ridges = ridged_noise(q * vec3(10, 16, 7), 3, 0.6f, settings_.seed + 32);
    const float value =
        settings_.veils * 0.08f * mask * smooth_step(0.55f, 0.95f, ridges * (0.6f + 0.4f * mask));
    return value > 0.0005f ? value : 0.0f;
  }
};

}  // namespace

std::unique_ptr<Shape> make_sandstorm(const ShapeSettings& settings) {
  return std::make_unique<Sandstorm>(settings);
}

}  // namespace plinian::procedural
