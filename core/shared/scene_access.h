// How the shared marches reach the scene. In C++ a MarchScene is passed along; in GLSL the same names stand
// for uniform blocks and textures, which viewport/passes/scene_access.glsl declares before it includes a
// march.
#ifndef PLINIAN_SHARED_SCENE_ACCESS_H
#define PLINIAN_SHARED_SCENE_ACCESS_H
#include "core/shared/glue.h"
#include "core/shared/scene_data.h"

#ifdef __cplusplus

#include "core/media/blackbody.h"
#include "core/media/brick_volume.h"

namespace plinian {

/// Light decoding as a map was encoded; see MapQuality.
struct MapLayout {
  int resolution = 0;    // texels along a side
  int coefficients = 0;  // cosine terms per texel
  float weighting = 1;   // T = series^weighting
};

/// RGBA32UI words that one texel of a map takes: 6 coefficients and the bounds, then 8 more, then 2 more.
inline int words_per_texel(int coefficients) {
  return coefficients > 14 ? 3 : coefficients > 6 ? 2 : 1;
}

/// Views into data that somebody else owns, for the length of a march.
struct MarchScene {
  const MediumData* media = nullptr;
  const BrickVolume* const* volumes = nullptr;  // one per medium; null for analytic shapes
  int media_count = 0;
  const LightData* lights = nullptr;
  int light_count = 0;
  const MapData* maps = nullptr;
  const uvec4* texels = nullptr;  // layer, row, column, then words_per_texel / 4 each
  MapLayout layout;
  int group_count = 0;
  bool varied_light = false;    // see FlatScene
  bool light_march = false;     // light is marched to every shading point instead of read from maps
  bool light_error = false;     // how far maps are from a march takes the place of light
  float light_march_step = 1;   // [voxels]
  float light_march_depth = 5;  // [-] optical depth at which it ends
};

namespace shared {

using Spectrum = vec3;
inline float spectrum_mean(Spectrum s) {
  return (s.x + s.y + s.z) * (1.0f / 3.0f);
}
inline vec3 spectrum_rgb(Spectrum s) {
  return s;
}
inline Spectrum spectrum_of(vec3 rgb) {
  return rgb;
}
inline glm::bvec3 spectrum_less(Spectrum s, float limit) {
  return glm::lessThan(s, vec3(limit));
}

inline uvec2 root_entry(const MarchScene& scene, int m, ivec3 cell) {
  const BrickVolume& v = *scene.volumes[m];
  if (cell.x < 0 || cell.y < 0 || cell.z < 0 || cell.x >= v.root_dims.x || cell.y >= v.root_dims.y ||
      cell.z >= v.root_dims.z)
    return uvec2(0u);
  return v.root[(std::size_t(cell.z) * v.root_dims.y + cell.y) * v.root_dims.x + cell.x];
}
inline uvec2 node_entry(const MarchScene& scene, int m, uint node, ivec3 child) {
  return scene.volumes[m]->nodes[std::size_t(node) * 512 + (child.z * 8 + child.y) * 8 + child.x];
}
inline float brick_value(const std::uint16_t* v, vec3 local) {
  const ivec3 base(glm::min(local, vec3(7.9999f)));
  const vec3 f = local - vec3(base);
  v += (base.z * 9 + base.y) * 9 + base.x;
  const auto row = [&](int o) { return v[o] + f.x * (float(v[o + 1]) - float(v[o])); };
  const float near = row(0) + f.y * (row(9) - row(0)), far = row(81) + f.y * (row(90) - row(81));
  return (near + f.z * (far - near)) * (1.0f / 65535.0f);
}
/// What a brick's stored maximum is relative to density_max.
inline float entry_scale(uvec2 entry) {
  return unpackHalf2x16(entry.y).y;
}
/// Stored density of a brick at a position in [0, 8]^3 from its first voxel, as a fraction of the brick's
/// maximum.
inline float brick_density(const MarchScene& scene, int m, uint brick, vec3 local) {
  return brick_value(scene.volumes[m]->density.data() + std::size_t(brick) * BrickVolume::brick_voxels,
                     local);
}
inline float brick_temperature(const MarchScene& scene, int m, uint brick, vec3 local) {
  const BrickVolume& v = *scene.volumes[m];
  if (brick >= v.hot_brick_count()) return 0.0f;
  return brick_value(v.temperature.data() + std::size_t(brick) * BrickVolume::brick_voxels, local);
}
inline vec3 blackbody(const MarchScene&, float kelvin) {
  return blackbody_colour(kelvin);
}
inline uvec4 map_texel(const MarchScene& scene, ivec2 texel, int layer, int word) {
  const int words = words_per_texel(scene.layout.coefficients);
  const std::size_t n = scene.layout.resolution;
  return scene.texels[((layer * n + texel.y) * n + texel.x) * words + word];
}

/// What steers the view march: the mean of the channels [1/world at stored density 1].
inline float sigma_guide(const MarchScene& scene, int m) {
  return spectrum_mean(scene.media[m].sigma_t);
}

}  // namespace shared
}  // namespace plinian

#define PLN_SCENE const MarchScene& scene
#define MEDIUM(m) scene.media[m]
#define LIGHT(l) scene.lights[l]
#define MAP(i) scene.maps[i]
#define FOR_MEDIA for (int m = 0; m < scene.media_count; ++m)
#define MEDIA_CAPACITY max_media
#define FOR_LIGHTS for (int l = 0; l < scene.light_count; ++l)
#define LIGHT_CAPACITY max_lights
#define FOR_GROUPS for (int g = 0; g < scene.group_count; ++g)
#define MAP_RESOLUTION scene.layout.resolution
#define MAP_COEFFICIENTS scene.layout.coefficients
#define MAP_WEIGHTING scene.layout.weighting
#define ANALYTIC_MEDIA true
#define SEVERAL_MEDIA true
#define DEEP_TREES true
#define EMISSIVE_MEDIA true
#define VARIED_LIGHT scene.varied_light
#define LIGHT_MARCH scene.light_march
#define LIGHT_ERROR scene.light_error
#define LIGHT_MARCH_STEP scene.light_march_step
#define LIGHT_MARCH_DEPTH scene.light_march_depth
#define GREY_EXTINCTION false

#endif
#endif
