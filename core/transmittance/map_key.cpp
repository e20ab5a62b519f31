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
    if (std::abs(a.sigma_group - b.sigma_group) > 1e-4f * std::max(a.sigma_group, b.sigma_group))
      return "extinction";
  }
  if (std::memcmp(&built.frame, &wanted.frame, sizeof built.frame) != 0) return "light frame";
  return "";
}

}  // namespace plinian
