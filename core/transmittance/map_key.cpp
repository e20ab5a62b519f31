#include "core/transmittance/map_key.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace plinian {

MapKey map_key(const FlatScene& scene, int map) {
  MapKey key;
  for (std::size_t m = 0; m < scene.media.size(); ++m) {
    const MediumData& medium = scene.media[m];
    if (medium.group != scene.maps[map].group || medium.sigma_group == 0.0f) continue;
    key.media.push_back({scene.volumes[m].get(), medium.local_from_world_x, medium.local_from_world_y,
                         medium.local_from_world_z, medium.shape, medium.sigma_group});
  }
  key.frame = scene.maps[map];
  key.frame.exponent = vec3(0.0f);
  key.frame.layer = key.frame.group = 0;
  key.encode = scene.encode;
  key.resolution = scene.layout.resolution;
  return key;
}

namespace {

constexpr float same_extinction = 1e-4f;

bool same_up_to_rounding(float a, float b) {
  return std::abs(a - b) <= same_extinction * std::max(a, b);
}

}  // namespace

std::string rebuild_reason(const MapKey& built, const MapKey& wanted) {
  if (built.resolution != wanted.resolution) return "map resolution";
  if (std::memcmp(&built.encode, &wanted.encode, sizeof built.encode) != 0) return "encoding";
  if (built.media.size() != wanted.media.size()) return "number of media";
  for (std::size_t m = 0; m < built.media.size(); ++m) {
    const auto &a = built.media[m], &b = wanted.media[m];
    if (a.volume != b.volume || a.shape != b.shape) return "density field";
    if (a.local_from_world_x != b.local_from_world_x || a.local_from_world_y != b.local_from_world_y ||
        a.local_from_world_z != b.local_from_world_z)
      return "transform";
    if (!same_up_to_rounding(a.sigma_group, b.sigma_group)) return "extinction";
  }
  if (std::memcmp(&built.frame, &wanted.frame, sizeof built.frame) != 0) return "light frame";
  return "";
}

std::optional<float> map_power(const MapKey& built, const MapKey& wanted, float reuse) {
  if (rebuild_reason(built, wanted).empty()) return 1.0f;
  if (!(reuse > 1.0f) || built.media.empty() || built.media.size() != wanted.media.size())
    return std::nullopt;
  // With every extinction taken for the map's, nothing else may differ.
  MapKey otherwise = wanted;
  const float power = wanted.media[0].sigma_group / built.media[0].sigma_group;
  if (power > reuse * (1.0f + same_extinction) || power * reuse < 1.0f - same_extinction) return std::nullopt;
  for (std::size_t m = 0; m < built.media.size(); ++m) {
    const float sigma = built.media[m].sigma_group;
    if (!same_up_to_rounding(power * sigma, wanted.media[m].sigma_group)) return std::nullopt;
    otherwise.media[m].sigma_group = sigma;
  }
  if (!rebuild_reason(built, otherwise).empty()) return std::nullopt;
  return power;
}

}  // namespace plinian
