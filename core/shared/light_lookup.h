// How much of a light arrives at a place, looked up in its maps.
#ifndef PLINIAN_SHARED_LIGHT_LOOKUP_H
#define PLINIAN_SHARED_LIGHT_LOOKUP_H
#include "core/shared/map_decode.h"
PLN_BEGIN

/// Which of the maps of light l looks at p: the cube face of a point light, else the first.
PLN_FN int map_face(PLN_SCENE, int l, vec3 p) {
  if (LIGHT(l).faces == 1) return 0;
  vec3 d = p - LIGHT(l).position;
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x >= 0.0f ? 0 : 1;
  if (a.y >= a.z) return d.y >= 0.0f ? 2 : 3;
  return d.z >= 0.0f ? 4 : 5;
}

/// Transmittance per channel from light l to any p: the product over the colour groups of their maps' scalar,
/// raised to each channel's share of extinction [TFM11 eq. 14].
PLN_FN vec3 light_through_maps(PLN_SCENE, int l, vec3 p) {
  vec3 product = vec3(1.0f);
  int face = map_face(scene, l, p);
  FOR_GROUPS {
    int map = LIGHT(l).first_map + g * LIGHT(l).faces + face;
    product *= pow(vec3(max(decode_anywhere(scene, map, p), 1e-20f)), MAP(map).exponent);
  }
  return product;
}

PLN_END
#endif
