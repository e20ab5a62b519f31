// Transmittance from light to a point, read from a map: each of the four texels around the point is
// reconstructed over its own bounds, then they are blended. Blending coefficients instead would mix series
// over different domains and costs 2 to 4 dB.
#ifndef PLINIAN_SHARED_MAP_DECODE_H
#define PLINIAN_SHARED_MAP_DECODE_H
#include "core/shared/cosine_texel.h"
#include "core/shared/scene_access.h"
PLN_BEGIN

/// T of one texel at distance k [world] along its light ray, to the power 1/weighting.
PLN_FN float decode_series(PLN_SCENE, ivec2 texel, int layer, float k, float depth) {
  uvec4 word = map_texel(scene, texel, layer, 0);
  uint bounds = word.w;
  float k_min = bounds_k_min(bounds, depth);
  float k_max = bounds_k_max(bounds, depth);
  float x = clamp((k - k_min) / max(k_max - k_min, 1e-30f), 0.0f, 1.0f);
  float u = cos_pi(x);
  vec2 c01 = unpackHalf2x16(word.x);
  vec2 c23 = unpackHalf2x16(word.y);
  vec2 c45 = unpackHalf2x16(word.z);
  // Clenshaw's recurrence, from the highest coefficient down.
  float b1 = 0.0f;
  float b2 = 0.0f;
  float b = 0.0f;
  if (MAP_COEFFICIENTS > 6) {
    uvec4 more = map_texel(scene, texel, layer, 1);
    vec2 c67 = unpackHalf2x16(more.x);
    vec2 c89 = unpackHalf2x16(more.y);
    vec2 cab = unpackHalf2x16(more.z);
    vec2 ccd = unpackHalf2x16(more.w);
    if (MAP_COEFFICIENTS > 14) {
      vec2 cef = unpackHalf2x16(map_texel(scene, texel, layer, 2).x);
      b2 = cef.y;
      b1 = cef.x + 2.0f * u * b2;
    }
    b = ccd.y + 2.0f * u * b1 - b2;
    b2 = b1;
    b1 = b;
    b = ccd.x + 2.0f * u * b1 - b2;
    b2 = b1;
    b1 = b;
    b = cab.y + 2.0f * u * b1 - b2;
    b2 = b1;
    b1 = b;
    b = cab.x + 2.0f * u * b1 - b2;
    b2 = b1;
    b1 = b;
    b = c89.y + 2.0f * u * b1 - b2;
    b2 = b1;
    b1 = b;
    b = c89.x + 2.0f * u * b1 - b2;
    b2 = b1;
    b1 = b;
    b = c67.y + 2.0f * u * b1 - b2;
    b2 = b1;
    b1 = b;
    b = c67.x + 2.0f * u * b1 - b2;
    b2 = b1;
    b1 = b;
  }
  b = c45.y + 2.0f * u * b1 - b2;
  b2 = b1;
  b1 = b;
  b = c45.x + 2.0f * u * b1 - b2;
  b2 = b1;
  b1 = b;
  b = c23.y + 2.0f * u * b1 - b2;
  b2 = b1;
  b1 = b;
  b = c23.x + 2.0f * u * b1 - b2;
  b2 = b1;
  b1 = b;
  b = c01.y + 2.0f * u * b1 - b2;
  float s = max(c01.x + u * b - b1, 0.0f);
  // In front of the bounds all light arrives; behind a dense range none does, behind a thin one the last
  // value.
  bool dead = k > k_max && bounds_dense(bounds);
  return k <= k_min ? 1.0f : (dead ? 0.0f : min(s, 1.0f));
}

PLN_FN float unweighted(PLN_SCENE, float series) {
  if (MAP_WEIGHTING == 1.0f) return series;
  if (MAP_WEIGHTING == 2.0f) return series * series;
  return pow(series, MAP_WEIGHTING);
}

/// Where p [world] is in a map: u and v in [0, 1] over its square, k [world] along the light ray.
PLN_FN vec3 map_place(PLN_SCENE, int map, vec3 p) {
  vec3 q = vec3(dot(vec3(MAP(map).row_u.x, MAP(map).row_u.y, MAP(map).row_u.z), p) + MAP(map).row_u.w,
                dot(vec3(MAP(map).row_v.x, MAP(map).row_v.y, MAP(map).row_v.z), p) + MAP(map).row_v.w,
                dot(vec3(MAP(map).row_k.x, MAP(map).row_k.y, MAP(map).row_k.z), p) + MAP(map).row_k.w);
  if (MAP(map).projection == projection_perspective)
    q = vec3(0.5f + q.x / q.z, 0.5f + q.y / q.z, length(p - MAP(map).ray_origin));
  return q;
}

/// Transmittance of the map's reference channel from the light to a place in the map within its depth.
PLN_FN float decode_place(PLN_SCENE, int map, vec3 place) {
  float u = place.x;
  float v = place.y;
  float k = place.z;
  float size = float(MAP_RESOLUTION);
  // In this order: at a lamp itself u and v are no numbers, and become 0.
  float s = min(size - 1.0f, max(0.0f, u * size - 0.5f));
  float t = min(size - 1.0f, max(0.0f, v * size - 0.5f));
  int column = min(int(s), MAP_RESOLUTION - 2);
  int row = min(int(t), MAP_RESOLUTION - 2);
  float fs = s - float(column);
  float ft = t - float(row);
  int layer = MAP(map).layer;
  float depth = MAP(map).k_max;
  float t00 = unweighted(scene, decode_series(scene, ivec2(column, row), layer, k, depth));
  float t10 = unweighted(scene, decode_series(scene, ivec2(column + 1, row), layer, k, depth));
  float t01 = unweighted(scene, decode_series(scene, ivec2(column, row + 1), layer, k, depth));
  float t11 = unweighted(scene, decode_series(scene, ivec2(column + 1, row + 1), layer, k, depth));
  return mix(mix(t00, t10, fs), mix(t01, t11, fs), ft);
}

/// Transmittance of the map's reference channel from the light to p [world], which is in a medium.
PLN_FN float decode_map(PLN_SCENE, int map, vec3 p) {
  return decode_place(scene, map, map_place(scene, map, p));
}

/// The same for any p. Outside the map's square no medium lies between, so it is 1; beyond its depth nothing
/// changes any more.
PLN_FN float decode_anywhere(PLN_SCENE, int map, vec3 p) {
  float before = dot(vec3(MAP(map).row_k.x, MAP(map).row_k.y, MAP(map).row_k.z), p) + MAP(map).row_k.w;
  if (MAP(map).projection == projection_perspective && before <= 0.0f) return 1.0f;  // behind a lamp
  vec3 place = map_place(scene, map, p);
  if (place.x < 0.0f || place.x > 1.0f || place.y < 0.0f || place.y > 1.0f) return 1.0f;
  // A texel without density says so of all that lies in front of the map's depth, and of no more.
  place.z = min(place.z, 0.9999f * MAP(map).k_max);
  return decode_place(scene, map, place);
}

PLN_END
#endif
