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
    raise_family({{0.40f, 0.80f, 1.2f, 0.74f, 0.30f, 0.85f},
                  {0.26f, 0.60f, 1.5f, 0.68f, 0.18f, 0.80f},
                  {0.22f, 0.52f, 1.5f, 0.64f, 0.05f, 0.85f},
                  {0.22f, 0.50f, 1.5f, 0.60f, -0.15f, 0.92f}},
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
    constexpr int columns = 13, rows = 6;
    for (int i = 0; i < columns; ++i) {
      const float x = 0.05f + 0.9f * static_cast<float>(i) / (columns - 1);
      const float side = std::fabs(x - 0.5f) * 2.0f;
      // The wall bends back and sinks towards its ends; in between it stands in buttresses.
      const float front =
          0.62f - 0.08f * side * side + 0.04f * sine(9.0f * x + phase) + random.uniform(-0.04f, 0.04f);
      const float height = 0.40f * (1.0f - 0.3f * side * side) *
                           (1.0f + 0.16f * sine(6.0f * x + 2.0f * phase)) * random.uniform(0.9f, 1.1f);
      // The face: a nose that runs ahead near the ground, a brow that hangs over, a crest that trails.
      for (int row = 0; row < rows; ++row) {
        const float up = (static_cast<float>(row) + 0.2f) / rows;
        const float ahead =
            settings_.lean * (0.045f * sine(8.0f * up + 0.3f) + 0.04f * up) - 0.10f * up * up * up;
        place({x, up * height, front + ahead}, 0.036f + 0.026f * up);
      }
      // The body behind, sinking away from the crest.
      for (int row = 0; row < 3; ++row) {
        const float back = 0.09f + 0.085f * static_cast<float>(row);
        const float top = height * (0.85f - 0.27f * static_cast<float>(row));
        for (float y = top; y > -0.03f; y -= 0.075f) place({x, y, front - back}, 0.058f);
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
