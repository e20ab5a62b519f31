// What core/shared/scene_access.h is in C++: the scene as uniform blocks and textures.
// Defines expected: MEDIA_COUNT, LIGHT_COUNT, MAP_COUNT, GROUP_COUNT, MAP_COEFFICIENTS, MAP_WEIGHTING,
// GREY_EXTINCTION, ANALYTIC_MEDIA, SEVERAL_MEDIA, DEEP_TREES.
#include "core/shared/blackbody_lookup.h"
#include "core/shared/scene_data.h"

// Place of a work group in a tile of 16 rows of them. llvmpipe gives each thread a run of groups: rows in the order
// of their reversed bits give each thread a share of every part of the tile.
ivec2 spread_group(uvec2 group) { return ivec2(int(group.x), int(bitfieldReverse(group.y) >> 28)); }

layout(std140, binding = 0) uniform MediaBlock { MediumData u_media[max_media]; };
layout(std140, binding = 1) uniform LightBlock { LightData u_lights[max_lights]; };
layout(std140, binding = 2) uniform MapBlock { MapData u_maps[max_maps]; };

layout(binding = 0) uniform usamplerBuffer u_map_texels;
layout(binding = 1) uniform sampler3D u_blackbody;
layout(binding = 2) uniform usamplerBuffer u_root[MEDIA_COUNT];
layout(binding = 2 + MEDIA_COUNT) uniform usamplerBuffer u_nodes[MEDIA_COUNT];
layout(binding = 2 + 2 * MEDIA_COUNT) uniform sampler3D u_density[MEDIA_COUNT];
layout(binding = 2 + 3 * MEDIA_COUNT) uniform sampler3D u_temperature[MEDIA_COUNT];

#define PLN_SCENE int scene
#unroll FOR_MEDIA m MEDIA_COUNT
#unroll FOR_LIGHTS l LIGHT_COUNT
#unroll FOR_GROUPS g GROUP_COUNT

// What is named by constants once loops are written out is copied first: llvmpipe reads a uniform for each lane alone
// wherever it is named, in the innermost loop too. A map's number is a constant only where there is one.
MediumData the_media[MEDIA_COUNT];
LightData the_lights[max(LIGHT_COUNT, 1)];
#define MEDIUM(m) the_media[m]
#define LIGHT(l) the_lights[l]
#if MAP_COUNT == 1
MapData the_map = u_maps[0];
#define MAP(i) the_map
#else
#define MAP(i) u_maps[i]
#endif

// Main calls this before anything else.
void copy_scene() {
  FOR_MEDIA the_media[m] = u_media[m];
  FOR_LIGHTS the_lights[l] = u_lights[l];
}

// Not a define: quick maps are as large as the time allows, and a program for each size would take longer than they.
int map_resolution = u_maps[0].resolution;
#define MAP_RESOLUTION map_resolution

#define MEDIA_CAPACITY MEDIA_COUNT
#define LIGHT_CAPACITY max(LIGHT_COUNT, 1)  // no array may be empty

#if GREY_EXTINCTION
#define Spectrum float
float spectrum_mean(float s) { return s; }
vec3 spectrum_rgb(float s) { return vec3(s); }
float spectrum_of(vec3 rgb) { return rgb.x; }
bool spectrum_less(float s, float limit) { return s < limit; }
#else
#define Spectrum vec3
float spectrum_mean(vec3 s) { return (s.x + s.y + s.z) * (1.0f / 3.0f); }
vec3 spectrum_rgb(vec3 s) { return s; }
vec3 spectrum_of(vec3 rgb) { return rgb; }
bvec3 spectrum_less(vec3 s, float limit) { return lessThan(s, vec3(limit)); }
#endif

float sigma_guide(int scene, int m) { return spectrum_mean(spectrum_of(MEDIUM(m).sigma_t)); }

// OF_MEDIUM(fetch) is `m == 0 ? fetch(0) : ...` (see scene_blocks.cpp): samplers are named by constants, because an
// index that varies must be the same for all invocations, and makes llvmpipe mix up every sampler of the program.
// A cell outside the root would be another's: the box of a medium's rays ends before (see local_ray()).
uvec2 root_entry(int scene, int m, ivec3 cell) {
  int place = (cell.z * MEDIUM(m).root_dims.y + cell.y) * MEDIUM(m).root_dims.x + cell.x;
#define FETCH(i) texelFetch(u_root[i], place).xy
  return OF_MEDIUM(FETCH);
#undef FETCH
}

uvec2 node_entry(int scene, int m, uint node, ivec3 child) {
  int place = int(node) * 512 + (child.z * 8 + child.y) * 8 + child.x;
#define FETCH(i) texelFetch(u_nodes[i], place).xy
  return OF_MEDIUM(FETCH);
#undef FETCH
}

// On the GPU a brick is named by its place in the atlas, 10 bits an axis: integer division would cost more than the
// lookup.
vec3 brick_place(uint brick) {
  return vec3(ivec3(int(brick & 1023u), int((brick >> 10) & 1023u), int(brick >> 20)) * 9);
}

// The maximum travels as a float, whose low bits, zero in what was a half, hold the octants.
float entry_scale(uvec2 entry) { return uintBitsToFloat(entry.y & 0xffffff00u); }

float brick_density(int scene, int m, uint brick, vec3 local) {
  vec3 place = (brick_place(brick) + local + 0.5) * MEDIUM(m).atlas_scale;
#define FETCH(i) textureLod(u_density[i], place, 0.0).x
  return OF_MEDIUM(FETCH);
#undef FETCH
}

// Hot bricks come first; the layers behind them hold no temperature.
float brick_temperature(int scene, int m, uint brick, vec3 local) {
  if (int(brick >> 20) >= MEDIUM(m).hot_layers) return 0.0;
  vec3 hot_scale = vec3(MEDIUM(m).atlas_scale.x, MEDIUM(m).atlas_scale.y, 1.0 / float(9 * MEDIUM(m).hot_layers));
  vec3 place = (brick_place(brick) + local + 0.5) * hot_scale;
#define FETCH(i) textureLod(u_temperature[i], place, 0.0).x
  return OF_MEDIUM(FETCH);
#undef FETCH
}

vec3 blackbody(int scene, float kelvin) {
  float position = blackbody_position(kelvin);
  int entry = min(int(position), blackbody_entries - 2);
  return mix(texelFetch(u_blackbody, ivec3(entry, 0, 0), 0).xyz, texelFetch(u_blackbody, ivec3(entry + 1, 0, 0), 0).xyz,
             position - float(entry));
}

uvec4 map_texel(int scene, ivec2 texel, int layer, int word) {
  const int words = MAP_COEFFICIENTS > 6 ? (MAP_COEFFICIENTS > 14 ? 3 : 2) : 1;
  return texelFetch(u_map_texels, ((layer * MAP_RESOLUTION + texel.y) * MAP_RESOLUTION + texel.x) * words + word);
}
