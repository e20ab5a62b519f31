// How much of a spot or point light arrives: falloff with distance and the soft edge of a cone. Stated once,
// for every renderer. Leaves out shadows (transmittance) and the light's own power.
//
// Convention: `axis` is the way a spot's beam runs and `from_lamp` the way from the lamp to the lit point,
// both unit.
#ifndef PLINIAN_SHARED_LIGHT_FALLOFF_H
#define PLINIAN_SHARED_LIGHT_FALLOFF_H
#include "core/shared/glue.h"
PLN_BEGIN

PLN_CONST int falloff_inverse_square = 0;  // values as in enum class Falloff
PLN_CONST int falloff_linear = 1;
PLN_CONST int falloff_none = 2;

/// Distances under this count as this [world units]: keeps a sample on a point light without a radius finite.
PLN_CONST float smallest_light_distance = 1e-6f;

/// Share of the irradiance at distance 1 that arrives at `distance` from a spot or point light: 1/r^2, 1/r or
/// 1 with r = max(distance, radius). distance, radius: [world] >= 0. Returns [-] >= 0, finite.
PLN_FN float distance_falloff(int kind, float distance, float radius) {
  float r = max(max(distance, radius), smallest_light_distance);
  if (kind == falloff_inverse_square) return 1.0f / (r * r);
  if (kind == falloff_linear) return 1.0f / r;
  return 1.0f;
}

/// Squared chord between two unit vectors at an angle [radians] in [0, pi]: 2 - 2 cos(angle), exact where the
/// cosine of a narrow cone would round away. Returns [-] in [0, 4].
PLN_FN float squared_chord(float angle) {
  float s = 2.0f * sin(0.5f * angle);
  return s * s;
}

/// Soft edge of a spot's cone: 1 inside `inner`, 0 outside `outer`, a smoothstep in the cosine of the angle
/// between. inner, outer: squared_chord() of cone_angle/2 - penumbra (not under 0) and of cone_angle/2; inner
/// >= outer is a hard edge at outer. Returns [-] in [0, 1].
PLN_FN float spot_edge(vec3 axis, vec3 from_lamp, float inner, float outer) {
  vec3 chord = from_lamp - axis;
  float c = dot(chord, chord);
  if (inner >= outer) return c < outer ? 1.0f : 0.0f;
  float x = clamp((outer - c) / (outer - inner), 0.0f, 1.0f);
  return x * x * (3.0f - 2.0f * x);
}

PLN_END
#endif
