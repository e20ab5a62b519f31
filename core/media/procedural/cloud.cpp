// The cumulus: a flat base, towers that bubble up from it, finer and softer lobes than ash.
#include <algorithm>
#include <cmath>

#include "core/media/procedural/kinds.h"
#include "core/media/procedural/noise.h"

namespace plinian::procedural {
namespace {

struct Tower {
  float x, z, height, radius;  // [design] x and z from the middle
};

constexpr Tower towers[] = {
    {-0.05f, 0.00f, 0.50f, 0.100f}, {0.16f, 0.05f, 0.33f, 0.084f},  {-0.22f, 0.05f, 0.25f, 0.076f},
    {0.06f, -0.14f, 0.36f, 0.085f}, {0.30f, -0.02f, 0.17f, 0.060f}, {-0.35f, -0.03f, 0.12f, 0.050f},
    {-0.08f, 0.16f, 0.20f, 0.070f}, {-0.15f, -0.15f, 0.3f, 0.075f}, {0.20f, 0.19f, 0.14f, 0.055f},
    {-0.26f, 0.18f, 0.10f, 0.048f},
};

class Cloud final : public BillowShape {
 public:
  explicit Cloud(const ShapeSettings& settings) : BillowShape(settings) {
    family_ = found_family(compose());
    const LobeScale scale = [this](vec3 centre, vec3 outward) {
      if (centre.y < base - 0.01f) return 0.0f;
      return (1.0f + 0.3f * gradient_noise(centre * 6.0f, settings_.seed + 5)) *
             (outward.y < -0.2f ? 0.65f : 1.0f);
    };
    warp_reach = 0.03f;
    raise_family({{0.38f, 0.78f, 1.2f, 0.72f, 0.25f, 0.86f},
                  {0.24f, 0.60f, 1.5f, 0.66f, 0.12f, 0.82f},
                  {0.22f, 0.52f, 1.5f, 0.62f, 0.00f, 0.86f},
                  {0.22f, 0.50f, 1.5f, 0.60f, -0.20f, 0.93f}},
                 scale);

    warp_wavelength = 0.023f;
    hull_reach = 0.1f;
    surface_reach = std::max(0.02f, edge(1.0f / static_cast<float>(settings.resolution)));
    solid_depth = 0.03f;
  }

  vec3 warp(vec3 p) const override {
    return room(p, 0.1f) * (0.011f * gradient_noise3(p * 10.0f, settings_.seed + 11) +
                            0.005f * gradient_noise3(p * 42.0f, settings_.seed + 12));
  }

  bool shade(const BlockField& field, float* density, float*) const override {
    fill_body(field, 0.35f, density);
    for (int i = 0; i < BlockField::count; ++i) {
      const vec3 p = field.position(i);
      // The condensation level: below it the air is clear, with a ragged edge.
      const float level = base + 0.006f * gradient_noise(p * vec3(14, 0, 14), settings_.seed + 41);
      const float above = smooth_step(-0.5f, 1.0f, (p.y - level) / std::max(0.012f, field.voxel));
      if (field.hull[i] > 0.0f && density[i] < 0.1f)
        density[i] = std::max(density[i], shreds(p, field.hull[i]));
      density[i] *= above;
    }
    return false;
  }

 private:
  static constexpr float base = 0.035f;  // [object] height of the flat underside

  std::vector<Lobe> compose() const {
    RandomStream random(hash(settings_.seed, 0xc1u));
    std::vector<Lobe> puffs;
    const auto place = [&](vec3 p, float radius) {
      puffs.push_back({p + random.direction() * (0.15f * radius), radius * random.uniform(0.9f, 1.1f)});
    };
    for (const Tower& tower : towers) {
      const float height = tower.height * random.uniform(0.85f, 1.12f);
      const vec3 foot = vec3(0.5f, 0.0f, 0.5f) + settings_.spread * vec3(tower.x, 0, tower.z);
      for (float y = 0.06f; y < height; y += 0.55f * tower.radius) {
        const float taper = 1.0f - 0.35f * y / height;
        place(foot + vec3(random.uniform(-0.3f, 0.3f), 0, random.uniform(-0.3f, 0.3f)) * tower.radius +
                  vec3(0, y, 0),
              tower.radius * taper);
      }
    }
    // The low puffs that join the towers.
    for (int i = 0; i < 26; ++i) {
      const float angle = 2.4f * static_cast<float>(i),
                  share = std::sqrt((static_cast<float>(i) + 0.5f) / 26.0f);
      place({0.5f + settings_.spread * 0.38f * share * cosine(angle), random.uniform(0.05f, 0.08f),
             0.5f + settings_.spread * 0.25f * share * sine(angle)},
            0.055f - 0.025f * share);
    }
    return puffs;
  }

  /// Shreds of evaporating cloud around the lower flanks.
  float shreds(vec3 p, float distance) const {
    const float mask =
        smooth_step(hull_reach, 0.0f, distance) * room(p, 0.04f) * smooth_step(0.5f, 0.1f, p.y);
    if (mask < 0.02f) return 0.0f;
    const vec3 q = p + 0.03f * gradient_noise3(p * 9.0f, settings_.seed + 31);
    const float n = fractal_noise(q * vec3(13, 20, 13), 3, 0.6f, settings_.seed + 32);
    const float value = settings_.veils * 0.05f * mask * smooth_step(0.05f, 0.5f, n);
    return value > 0.0005f ? value : 0.0f;
  }
};

}  // namespace

std::unique_ptr<Shape> make_cloud(const ShapeSettings& settings) {
  return std::make_unique<Cloud>(settings);
}

}  // namespace plinian::procedural
