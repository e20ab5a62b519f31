// The scene as the marches read it: plain structs, laid out as std140 blocks so that C++ fills what GLSL
// reads. Made from a SceneSnapshot by core/integrate/flat_scene.cpp; space and unit stand beside each field.
#ifndef PLINIAN_SHARED_SCENE_DATA_H
#define PLINIAN_SHARED_SCENE_DATA_H
#include "core/shared/glue.h"

#ifdef __cplusplus
namespace plinian {
#endif

// MediumData::shape
PLN_CONST int shape_voxels = 0;
PLN_CONST int shape_box = 1;
PLN_CONST int shape_sphere = 2;

// LightData::type
PLN_CONST int light_directional = 0;
PLN_CONST int light_spot = 1;
PLN_CONST int light_point = 2;

// MapData::projection
PLN_CONST int projection_orthographic = 0;
PLN_CONST int projection_perspective = 1;

PLN_CONST int max_media = 8;   // of one scene
PLN_CONST int max_lights = 8;  // of one march; more lights take more marches
PLN_CONST int max_maps = 64;   // layers over all lights, colour groups and cube faces of one march
PLN_CONST int max_coefficients = 16;

struct MediumData {
  vec4 local_from_world_x;  // rows of the affine map from world to the medium's own space: index space of
                            // voxels,
  vec4 local_from_world_y;  // [-1, 1]^3 of a box, the unit ball of a sphere
  vec4 local_from_world_z;
  vec3 sigma_t;             // [1/world] extinction at stored density 1
  float sigma_group;        // [1/world] extinction that this medium adds to its colour group's map
  vec3 sigma_s;             // [1/world] scattering at stored density 1
  float emission;           // [radiance/world] at stored density 1 and 1800 K; 0: none
  vec3 bounds_min;          // [local] box outside which there is no density
  float density_scale;      // [-] density * density_scale of stored density 1
  vec3 bounds_max;          // [local]
  float temperature_scale;  // [K] of a stored temperature of 1
  ivec3 root_origin;        // [voxels] see BrickVolume
  int levels;
  ivec3 root_dims;  // [cells]
  int shape;
  vec3 atlas_scale;  // [1/texels] of the density atlas (GL only)
  int hot_layers;    // [bricks] layers of the atlas that have temperatures (GL only)
  int phase_kind;
  float g;                   // [-]
  float g_back;              // [-]
  float blend;               // [-]
  float temperature_offset;  // [K]
  int group;                 // colour group
  float pad0, pad1;
};

struct LightData {
  vec3 power;  // irradiance (directional) or irradiance at distance 1
  int type;
  vec3 position;  // [world]
  float radius;   // [world]
  vec3 toward;    // [-] unit, to the light
  int falloff;
  float cone_inner;  // [-] squared_chord() of the cone's half angle less its soft edge
  float cone_outer;  // [-] squared_chord() of the cone's half angle
  int first_map;     // of MapData: first_map + group * faces + face
  int faces;         // 1, or 6 for a point light
};

/// One view of a light: a square of texels, each a transmittance function along its ray.
/// q = rows * p: orthographic: q.x, q.y in [0, 1] over the map, q.z = k; perspective: q relative to the
/// light, u = 0.5 + q.x / q.z, v = 0.5 + q.y / q.z, k = distance from the light.
struct MapData {
  vec4 row_u;
  vec4 row_v;
  vec4 row_k;
  vec3 exponent;    // [-] sigma_t per channel / the extinction that the map was built for [TFM11 eq. 14]
  float k_max;      // [world] what a stored bound of one stands for
  vec3 ray_origin;  // [world] orthographic: of texel (0, 0)'s corner; perspective: the light
  int projection;
  vec3 ray_u;  // [world] orthographic: origin moves by u * ray_u + v * ray_v and the direction is ray_k;
  int layer;   // perspective: direction = normalize(ray_k + (2u - 1) * ray_u + (2v - 1) * ray_v)
  vec3 ray_v;
  int group;
  vec3 ray_k;
  int resolution;  // texels along a side; the same for all maps of a march
};

#ifdef __cplusplus
static_assert(sizeof(MediumData) == 192 && sizeof(LightData) == 64 && sizeof(MapData) == 128);
}  // namespace plinian
#endif
#endif
