// Building one texel of a transmittance map: the dual adaptive march of [ATFM13 Algorithm 2], with named
// options where measurement says that another choice serves dense media better.
//
// The series is projected from T^(1/weighting) taken as linear between the nodes of the march. With
// c_j = 2 integral T cos(j pi x) dx, integration by parts leaves only the slopes (sin(j pi x) vanishes at
// both ends): c_j = 2 sum_segments slope * (cos(j pi x_b) - cos(j pi x_a)) / (j pi)^2. Empty space, where the
// slope is zero, costs nothing, and no segment is sampled more than once.
#ifndef PLINIAN_SHARED_LIGHT_MARCH_H
#define PLINIAN_SHARED_LIGHT_MARCH_H
#include "core/shared/cosine_texel.h"
#include "core/shared/walk.h"
PLN_BEGIN

/// How maps are encoded; see MapQuality for the meaning of each.
struct EncodeControls {
  int coefficients;
  int adaptive;    // 0: tfm, 1: atfm
  int veil_proof;  // 1: kmin where T < kmin_transmittance
  int end_zero;    // 1: nothing gets through behind kmax of a dense texel; 0: the series' last value
  float kmin_transmittance;
  float threshold;
  float inverse_weighting;  // 1 / density_weighting
  float step;               // [voxels] of the first march
  int refine_steps;
};

struct LightBounds {
  float k_min;
  float k_max;
  float tau_min;  // optical depth gathered at k_min
  bool dense;
  bool missed;
};

/// First march: where light begins to fade and where it is dead.
PLN_FN LightBounds detect_bounds(PLN_SCENE, vec3 origin, vec3 direction, int group, EncodeControls controls) {
  LightBounds bounds;
  Walk walk = walk_begin(scene, origin, direction, 0.0f, controls.step, 0.0f, group);
  float k_in = walk.t;
  float k_out = walk.t_end;
  bounds.k_min = k_in;
  bounds.k_max = k_out;
  bounds.tau_min = 0.0f;
  bounds.dense = false;
  bounds.missed = !(k_out > k_in);
  float tau = 0.0f;
  float tau_dead = -log(controls.threshold);
  float tau_first = controls.veil_proof != 0 ? -log(controls.kmin_transmittance) : 0.0f;
  bool begun = false;
  bool alive = controls.adaptive != 0 && !bounds.missed;
  while (alive) {
    alive = walk.t_b < walk.t_end;
    if (alive) {
      walk.steep = steep_at(tau);
      walk_advance(scene, walk);
      float sigma_a = 0.0f;  // [1/world] of the group's reference channel
      float sigma_b = 0.0f;
      FOR_MEDIA {
        sigma_a += walk.a[m] * MEDIUM(m).sigma_group;
        sigma_b += walk.b[m] * MEDIUM(m).sigma_group;
      }
      float dt = walk.t_b - walk.t;
      float gain = 0.5f * (sigma_a + sigma_b) * dt;
      if (!begun && tau + gain > tau_first) {
        begun = true;
        float into = length_to_optical_depth(sigma_a, sigma_b, dt, tau_first - tau);
        bounds.k_min = walk.t + into;
        bounds.tau_min = tau_first;
      }
      if (tau + gain > tau_dead) {
        bounds.k_max = walk.t + length_to_optical_depth(sigma_a, sigma_b, dt, tau_dead - tau);
        bounds.dense = true;
        alive = false;
      }
      tau += gain;
    }
  }
  if (!bounds.dense) {
    // Thin: untouched, the whole ray is projected.
    bounds.k_min = k_in;
    bounds.k_max = k_out;
    bounds.tau_min = 0.0f;
  }
  return bounds;
}

/// The light ray through (u, v) in [0, 1]^2 of a map: k runs along it from its origin.
PLN_FN vec3 map_ray_origin(PLN_SCENE, int map, vec2 uv) {
  if (MAP(map).projection == projection_perspective) return MAP(map).ray_origin;
  return MAP(map).ray_origin + uv.x * MAP(map).ray_u + uv.y * MAP(map).ray_v;
}
PLN_FN vec3 map_ray_direction(PLN_SCENE, int map, vec2 uv) {
  if (MAP(map).projection == projection_orthographic) return MAP(map).ray_k;
  return normalize(MAP(map).ray_k + (2.0f * uv.x - 1.0f) * MAP(map).ray_u +
                   (2.0f * uv.y - 1.0f) * MAP(map).ray_v);
}

/// Both marches for the ray of one texel. depth: [world] what a bound of one stands for. c receives the
/// coefficients. Returns the bounds_bits bounds.
PLN_FN uint encode_texel(PLN_SCENE, vec3 origin, vec3 direction, int group, float depth,
                         EncodeControls controls, PLN_COEFFICIENTS(c)) {
  for (int j = 0; j < 16; ++j) c[j] = 0.0f;
  LightBounds found = detect_bounds(scene, origin, direction, group, controls);
  if (found.missed) return missed_bounds();
  uint bounds_bits = pack_bounds(found.k_min, found.k_max, found.dense && controls.end_zero != 0, depth);
  // Project over the bounds as stored, so that their rounding costs nothing.
  float k_min = bounds_k_min(bounds_bits, depth);
  float k_max = bounds_k_max(bounds_bits, depth);
  float range = k_max - k_min;
  float tau = found.tau_min;
  float previous_x = 0.0f;
  // T^(1/w) at previous_x, and up to the next piece.
  float previous_t = exp(-tau * controls.inverse_weighting);
  bool alive = true;
  Walk walk = walk_begin(scene, origin, direction, k_min, controls.step, 0.0f, group);
  float fine = range / float(controls.refine_steps);
  float area = 0.0f;
  while (alive) {
    alive = walk.t_b < min(walk.t_end, k_max);
    if (alive) {
      walk.steep = steep_at(tau);
      walk_advance(scene, walk);
      float sigma_a = 0.0f;  // [1/world] of the group's reference channel
      float sigma_b = 0.0f;
      FOR_MEDIA {
        sigma_a += walk.a[m] * MEDIUM(m).sigma_group;
        sigma_b += walk.b[m] * MEDIUM(m).sigma_group;
      }
      float dt = walk.t_b - walk.t;
      float slope = (sigma_b - sigma_a) / max(dt, 1e-30f);
      // The part of the segment inside the bounds, in pieces short enough for a straight line. Extinction is
      // linear along the segment, so the pieces need no further lookups.
      float from = max(k_min - walk.t, 0.0f);
      float to = min(k_max - walk.t, dt);
      int pieces = to > from ? int(clamp(ceil((to - from) / fine), 1.0f, float(controls.refine_steps))) : 0;
      for (int i = 0; i < pieces; ++i) {
        float begin = mix(from, to, float(i) / float(pieces));
        float end = mix(from, to, float(i + 1) / float(pieces));
        float x_a = clamp((walk.t + begin - k_min) / range, 0.0f, 1.0f);
        float x_b = clamp((walk.t + end - k_min) / range, 0.0f, 1.0f);
        float t_b = exp(-(tau + end * (sigma_a + 0.5f * slope * end)) * controls.inverse_weighting);
        // What lies between the last piece and this one is empty: constant T.
        area += previous_t * (x_a - previous_x) + 0.5f * (previous_t + t_b) * (x_b - x_a);
        float gradient = x_b > x_a ? (t_b - previous_t) / (x_b - x_a) : 0.0f;
        float a1 = cos_pi(x_a);
        float b1 = cos_pi(x_b);
        float a0 = 1.0f;
        float b0 = 1.0f;
        float a = a1;
        float b = b1;
        for (int j = 1; j < controls.coefficients; ++j) {
          c[j] += gradient * (b - a);
          float a2 = 2.0f * a1 * a - a0;
          float b2 = 2.0f * b1 * b - b0;
          a0 = a;
          b0 = b;
          a = a2;
          b = b2;
        }
        previous_x = x_b;
        previous_t = t_b;
      }
      tau += 0.5f * (sigma_a + sigma_b) * dt;
    }
  }
  area += previous_t * (1.0f - previous_x);
  c[0] = area;
  for (int j = 1; j < controls.coefficients; ++j) c[j] *= 2.0f / (pi * pi * float(j * j));
  return bounds_bits;
}

PLN_END
#endif
