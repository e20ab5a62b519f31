// For shaders of somebody else's: how much of a light of the picture arrives at a place, by its maps. Goes behind their
// version line, and declares but one block, one sampler and the names of core/shared.
// Defines expected: GROUP_COUNT, MAP_COEFFICIENTS, MAP_WEIGHTING.
#include "core/shared/scene_data.h"

layout(std140) uniform PlinianLights {
  LightData plinian_light_data[max_lights];
  MapData plinian_map_data[max_maps];
};
uniform usamplerBuffer plinian_map_texels;

#define PLN_SCENE int scene
#define LIGHT(l) plinian_light_data[l]
#define MAP(i) plinian_map_data[i]
#define MAP_RESOLUTION plinian_map_data[0].resolution
#define FOR_GROUPS for (int g = 0; g < GROUP_COUNT; ++g)

uvec4 map_texel(int scene, ivec2 texel, int layer, int word) {
  const int words = MAP_COEFFICIENTS > 6 ? (MAP_COEFFICIENTS > 14 ? 3 : 2) : 1;
  return texelFetch(plinian_map_texels, ((layer * MAP_RESOLUTION + texel.y) * MAP_RESOLUTION + texel.x) * words + word);
}

#include "core/shared/light_lookup.h"

// The share [-] per channel of the light of that number that arrives at a place [world].
vec3 plinian_light(int light, vec3 place) { return light_through_maps(0, light, place); }
