#include "core/integrate/map_texel.h"

#include <glm/gtc/packing.hpp>

namespace plinian {

void write_map_texel(const FlatScene& flat, const MarchScene& scene, int map, ivec2 texel, uvec4* words) {
  const vec2 uv = (vec2(texel) + 0.5f) / float(flat.layout.resolution);
  float c[16];
  const uint bounds = shared::encode_texel(scene, shared::map_ray_origin(scene, map, uv),
                                           shared::map_ray_direction(scene, map, uv), scene.maps[map].group,
                                           scene.maps[map].k_max, flat.encode, c);
  const auto pair = [&](int j) { return glm::packHalf2x16(vec2(c[j], c[j + 1])); };
  const int count = words_per_texel(flat.layout.coefficients);
  words[0] = {pair(0), pair(2), pair(4), bounds};
  if (count > 1) words[1] = {pair(6), pair(8), pair(10), pair(12)};
  if (count > 2) words[2] = {pair(14), 0u, 0u, 0u};
}

}  // namespace plinian
