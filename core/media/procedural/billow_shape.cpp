// What the kinds of procedural media share.
#include <algorithm>

#include "core/media/procedural/kinds.h"
#include "core/media/procedural/lattice.h"
#include "core/media/procedural/noise.h"

namespace plinian::procedural {

Growth BillowShape::styled(Growth usual) const {
  usual.smallest *= settings_.billow_size;
  usual.largest *= settings_.billow_size;
  usual.stand_out += 0.4f * (settings_.displacement - 1.0f);
  usual.core = std::max(0.5f, 1.0f - (1.0f - usual.core) * settings_.displacement);
  return usual;
}

void BillowShape::raise_family(const std::vector<Growth>& usual, const LobeScale& scale) {
  const std::uint32_t key = hash(settings_.seed, 0x1f7u);
  for (std::uint32_t g = 0; g < usual.size(); ++g) {
    const Growth growth = styled(usual[g]);
    // The first two generations grow whole, so that how they fit does not depend on the resolution.
    grow(family_, growth, key + g, g < 2 ? 0.0f : least_radius(), scale);
    if (g != 1) continue;
    fit_ = fit_family(family_, 1.45f, 0.03f);
    prune(family_, growth, least_radius());
  }
}

void BillowShape::fill_body(const BlockField& field, float variation, float* density) const {
  for_each_interpolated(
      field.corner, field.voxel, 0.04f,
      [&](vec3 p) {
        return 1.0f - variation * (0.5f - 0.7f * fractal_noise(p * 12.0f, 2, 0.5f, settings_.seed + 21));
      },
      [&](int i, float thickness) { density[i] = std::clamp(thickness, 0.0f, 1.0f); });
  const float half_width = edge(field.voxel);
  for (int i = 0; i < BlockField::count; ++i)
    density[i] *= smooth_step(half_width, -half_width, field.surface[i]);
}

float BillowShape::room(vec3 position, float width) {
  const vec3 inside = 0.5f - glm::abs(position - 0.5f);
  return smooth_step(0.1f * width, width, std::min({inside.x, inside.z, 1.0f - position.y}));
}

}  // namespace plinian::procedural
