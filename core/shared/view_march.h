// The view march: single scattering along a camera ray, with light read from transmittance maps.
//
// Everything visible of a dense medium happens in its first few optical depths, so light is looked up where
// opacity is gained: the ray's opacity is cut into equal quanta, cheap density samples find where each begins
// and ends (inside a voxel too: extinction is linear between samples and can be inverted), and each quantum
// is shaded once. All rays of a SIMD group shade together. Every piece of the ray is integrated analytically,
// so coarse steps lose no energy.
#ifndef PLINIAN_SHARED_VIEW_MARCH_H
#define PLINIAN_SHARED_VIEW_MARCH_H
#include "core/shared/blackbody_lookup.h"
#include "core/shared/light_falloff.h"
#include "core/shared/light_lookup.h"
#include "core/shared/light_march.h"
#include "core/shared/phase.h"
PLN_BEGIN

struct ViewControls {
  float quantum;  // [-] opacity gained between two light lookups
  float skin;     // [-] share of a quantum that the first one is; they grow with the opacity in front
  float step;     // [voxels] between density samples
  float lead;     // [voxels] in [0, step): jitter of the density samples
  float place;    // [-] in (0, 1): share of a quantum's opacity in front of its lookup
  float deep;     // [-] >= 1: how much coarser density is sampled where little of it is seen
  float cutoff;   // [-] transmittance at which the ray ends
};

/// The direction through a pixel's centre [world], unit; rows run downwards. See CameraRays.
PLN_FN vec3 pixel_direction(vec3 forward, vec3 right, vec3 up, ivec2 pixel, ivec2 size) {
  float x = 2.0f * (float(pixel.x) + 0.5f) / float(size.x) - 1.0f;
  float y = 1.0f - 2.0f * (float(pixel.y) + 0.5f) / float(size.y);
  return normalize(forward + x * right + y * up);
}

/// A hash of a pixel to [0, 1) (PCG, O'Neill 2014, in one round).
PLN_FN float pixel_hash(ivec2 pixel) {
  uint x = uint(pixel.x) * 1664525u + uint(pixel.y) * 747796405u + 2891336453u;
  x = ((x >> ((x >> 28) + 4u)) ^ x) * 277803737u;
  x = (x >> 22) ^ x;
  return float(x >> 8) * (1.0f / 16777216.0f);
}

/// Controls of pass number `pass` at a pixel. The first pass shades where half of a quantum's opacity is
/// gained, without noise; later ones take their places from Roberts' R2 sequence, shifted per pixel, so that
/// the mean converges to the integral.
PLN_FN ViewControls view_controls(ivec2 pixel, int pass, float quantum, float step, float cutoff) {
  float shift = pixel_hash(pixel);
  float first = fract(shift + float(pass) * 0.7548776662f);
  float second = fract(shift + float(pass) * 0.5698402910f);
  ViewControls controls;
  // Further passes are finer, as what they add has to be finer. Light that just grazes what shadows the
  // surface reaches the first hundredths of its opacity alone, and is bright there: were they but a part of
  // the first quantum, most passes would miss it, and those that do not would leave speckle.
  controls.quantum = pass == 0 ? quantum : 0.25f * quantum;
  controls.skin = pass == 0 ? 1.0f : 0.0625f;
  controls.step = pass == 0 ? step : 0.125f * step;
  controls.deep = pass == 0 ? 10.0f : 1.0f;
  controls.lead = pass == 0 ? 0.0f : controls.step * first;
  controls.place = pass == 0 ? 0.5f : second;
  controls.cutoff = pass == 0 ? cutoff : 0.1f * cutoff;
  return controls;
}

struct ViewResult {
  vec3 transmittance;
  float depth;                 // [world] where alpha passes 0.5; 1e30 if never
  vec3 ambient;                // [-] in-scattered share, to be multiplied by L_a
  vec3 emission;               // [radiance]
  vec3 light[LIGHT_CAPACITY];  // [radiance]
};

/// (1 - e^-tau) / tau, exact towards tau = 0.
PLN_FN Spectrum mean_transmittance(Spectrum tau) {
  return mix((1.0f - exp(-tau)) / max(tau, Spectrum(1e-6f)), Spectrum(1.0f) - 0.5f * tau,
             spectrum_less(tau, 2e-3f));
}

/// Share of a light's power that would arrive at p if nothing stood between.
PLN_FN float light_arrival(PLN_SCENE, int l, vec3 p) {
  if (LIGHT(l).type == light_directional) return 1.0f;
  vec3 from_lamp = p - LIGHT(l).position;
  float distance = length(from_lamp);
  float arrival = distance_falloff(LIGHT(l).falloff, distance, LIGHT(l).radius);
  if (LIGHT(l).type == light_spot)
    arrival *= spot_edge(-LIGHT(l).toward, from_lamp / max(distance, smallest_light_distance),
                         LIGHT(l).cone_inner, LIGHT(l).cone_outer);
  return arrival;
}

/// The way light travels from light l at p.
PLN_FN vec3 light_travel(PLN_SCENE, int l, vec3 p) {
  if (LIGHT(l).type == light_directional) return -LIGHT(l).toward;
  vec3 from_lamp = p - LIGHT(l).position;
  return from_lamp / max(length(from_lamp), smallest_light_distance);
}

/// Optical depth of colour group g's reference channel between p and light l, marched; ends where it passes
/// LIGHT_MARCH_DEPTH.
PLN_FN float march_light(PLN_SCENE, int l, int g, vec3 p) {
  Walk walk = walk_begin(scene, p, -light_travel(scene, l, p), 0.0f, LIGHT_MARCH_STEP, 0.0f, g);
  float reach = LIGHT(l).type == light_directional ? 1e30f : length(p - LIGHT(l).position);
  float end = min(walk.t_end, reach);
  float tau = 0.0f;
  while (walk.t_b < end && tau < LIGHT_MARCH_DEPTH) {
    walk.steep = steep_at(tau);
    walk_advance(scene, walk);
    float length_inside = min(walk.t_b, end) - min(walk.t, end);
    FOR_MEDIA tau += 0.5f * (walk.a[m] + walk.b[m]) * length_inside * MEDIUM(m).sigma_group;
  }
  return tau;
}

/// Transmittance per channel from light l to p, marched or read from its maps: the product over the colour
/// groups of their scalar, raised to each channel's share of extinction [TFM11 eq. 14].
PLN_FN vec3 light_transmittance(PLN_SCENE, int l, vec3 p, bool marched) {
  vec3 product = vec3(1.0f);
  int face = map_face(scene, l, p);
  FOR_GROUPS {
    int map = LIGHT(l).first_map + g * LIGHT(l).faces + face;
    float t = marched ? exp(-march_light(scene, l, g, p)) : decode_map(scene, map, p);
    if (GREY_EXTINCTION)
      // Of a map that was built for another extinction.
      product *= marched || MAP(map).exponent.x == 1.0f ? t : pow(max(t, 1e-20f), MAP(map).exponent.x);
    else
      product *= pow(vec3(max(t, 1e-20f)), MAP(map).exponent);
  }
  return product;
}

/// Kelvin of voxel medium m at p.
PLN_FN float medium_temperature(PLN_SCENE, int m, LocalRay ray, float t) {
  vec3 p = ray.origin + t * ray.direction;
  ivec3 corner;
  int size;
  uvec2 entry = find_cell(scene, m, ivec3(floor(p)), corner, size);
  float stored = 0.0f;
  if (entry.x >= 0x80000000u) stored = brick_temperature(scene, m, entry.x & 0x7fffffffu, p - vec3(corner));
  return MEDIUM(m).temperature_offset + MEDIUM(m).temperature_scale * stored;
}

/// Adds how far the maps are from a march at p to each light's layer, weighted by the opacity there.
PLN_FN void shade_error(PLN_SCENE, Spectrum gathered[MEDIA_CAPACITY], vec3 p, PLN_INOUT(ViewResult) result) {
  vec3 opacity = vec3(0.0f);
  FOR_MEDIA opacity += MEDIUM(m).sigma_t * spectrum_rgb(gathered[m]);
  FOR_LIGHTS result.light[l] +=
      opacity * abs(light_transmittance(scene, l, p, true) - light_transmittance(scene, l, p, false));
}

/// Adds the light of one quantum: gathered[m] is the integral of T * density of each medium over it, shaded
/// at t.
PLN_FN void shade(PLN_SCENE, Walk walk, Spectrum gathered[MEDIA_CAPACITY], vec3 origin, vec3 direction,
                  float t, PLN_INOUT(ViewResult) result) {
  vec3 p = origin + t * direction;
  if (LIGHT_ERROR) {
    shade_error(scene, gathered, p, result);
    return;
  }
  FOR_LIGHTS {
    float cos_theta = dot(light_travel(scene, l, p), -direction);
    vec3 scattered = vec3(0.0f);
    FOR_MEDIA
    scattered +=
        MEDIUM(m).sigma_s * spectrum_rgb(gathered[m]) *
        phase_function(MEDIUM(m).phase_kind, cos_theta, MEDIUM(m).g, MEDIUM(m).g_back, MEDIUM(m).blend);
    result.light[l] += scattered * LIGHT(l).power *
                       (light_arrival(scene, l, p) * light_transmittance(scene, l, p, LIGHT_MARCH));
  }
  FOR_MEDIA {
    result.ambient += MEDIUM(m).sigma_s * spectrum_rgb(gathered[m]);
    if (EMISSIVE_MEDIA && MEDIUM(m).emission > 0.0f) {
      float kelvin = MEDIUM(m).shape == shape_voxels ? medium_temperature(scene, m, walk.rays[m], t)
                                                     : MEDIUM(m).temperature_offset;
      float relative = kelvin * (1.0f / 1800.0f);
      float brightness = MEDIUM(m).emission * relative * relative * relative * relative;
      result.emission += brightness * blackbody(scene, kelvin) * spectrum_rgb(gathered[m]);
    }
  }
}

PLN_FN ViewResult march_view(PLN_SCENE, vec3 origin, vec3 direction, float t_near, ViewControls controls) {
  ViewResult result;
  result.depth = 1e30f;
  result.ambient = vec3(0.0f);
  result.emission = vec3(0.0f);
  FOR_LIGHTS result.light[l] = vec3(0.0f);

  float guide_sigma[MEDIA_CAPACITY];  // what steers the march: the mean of the channels
  FOR_MEDIA guide_sigma[m] = sigma_guide(scene, m);

  Walk walk = walk_begin(scene, origin, direction, t_near, controls.step, controls.lead, -1);
  // In a haze, light varies where little opacity is gained: there a quantum ends after some length, too.
  float longest = 0.5f * controls.quantum * (walk.t_end - walk.t);
  Spectrum seen = Spectrum(1.0f);  // transmittance up to walk.t
  float seen_mean = 1.0f;
  bool alive = walk.t_end > walk.t;
  while (alive) {
    walk.steep = steep_segment * min(1.0f / seen_mean, controls.deep);
    // The quantum: equal shares of opacity, but the last would reach to infinite depth, so towards the end
    // they shrink with what is left. One always ends where alpha passes 0.5: that is the depth.
    float quantum = min(controls.quantum, controls.skin * controls.quantum + (1.0f - seen_mean));
    float target = max(seen_mean - quantum, 0.25f * seen_mean);
    if (result.depth > 1e29f) target = max(target, 0.5f);
    float tau_target = log(seen_mean / target);
    // Where `place` of its opacity is gained the quantum is shaded: always in matter, never in a gap between
    // two puffs, where there is more light than either sees.
    float tau_place = -log(1.0f - controls.place * (1.0f - target / seen_mean));
    float shading_t = -1.0f;

    float column[MEDIA_CAPACITY];  // [world * stored density] gathered in this quantum
    FOR_MEDIA column[m] = 0.0f;
    float tau = 0.0f;
    float begin = 1e30f;  // where the quantum's density begins
    float moment = 0.0f;  // of tau, lengths counted from `begin`
    bool full = false;
    bool gathering = true;
    while (gathering) {
      // The rest of the current segment: extinction at both ends.
      float guide_a = 0.0f;
      float guide_b = 0.0f;
      FOR_MEDIA {
        guide_a += walk.a[m] * guide_sigma[m];
        guide_b += walk.b[m] * guide_sigma[m];
      }
      float rest = walk.t_b - walk.t;
      float gain = 0.5f * (guide_a + guide_b) * rest;
      // Decided once: tau + (tau_target - tau) may round to less than tau_target, and the rest of the
      // segment would be lost.
      full = tau + gain >= tau_target;
      float piece = rest;
      piece = full ? length_to_optical_depth(guide_a, guide_b, rest, tau_target - tau) : piece;
      gain = full ? tau_target - tau : gain;
      float matter_here = 0.0f;
      FOR_MEDIA matter_here += walk.a[m] + walk.b[m];
      if (matter_here > 0.0f) begin = min(begin, walk.t);
      if (VARIED_LIGHT) {
        float room = max(begin + longest - walk.t, 0.0f);
        if (piece > room) {
          piece = room;
          gain = (guide_a + 0.5f * (guide_b - guide_a) * piece / rest) * piece;
          full = true;
          if (tau + gain < tau_place) shading_t = mix(begin, walk.t + piece, controls.place);
        }
      }
      float share = rest > 0.0f ? piece / rest : 1.0f;
      bool here = tau <= tau_place && tau + gain > tau_place;
      shading_t =
          here ? walk.t + length_to_optical_depth(guide_a, guide_b, rest, tau_place - tau) : shading_t;
      moment += gain * (walk.t + 0.5f * piece - begin);
      tau += gain;
      FOR_MEDIA {
        float end = mix(walk.a[m], walk.b[m], share);
        column[m] += 0.5f * (walk.a[m] + end) * piece;
        walk.a[m] = end;
      }
      walk.t += piece;
      gathering = !full;
      if (!full) {
        alive = walk.t_b < walk.t_end;
        gathering = alive;
        if (alive) walk_advance(scene, walk);
      }
    }

    Spectrum spectral_tau = Spectrum(0.0f);
    FOR_MEDIA spectral_tau += column[m] * spectrum_of(MEDIUM(m).sigma_t);
    Spectrum left = seen * exp(-spectral_tau);
    // A ray that ends early scatters what it leaves out, too, as if this quantum went on.
    bool ends = full && spectrum_mean(left) < controls.cutoff;
    Spectrum mean_seen =
        ends ? seen / max(spectral_tau, Spectrum(1e-6f)) : seen * mean_transmittance(spectral_tau);
    Spectrum gathered[MEDIA_CAPACITY];
    float matter = 0.0f;
    FOR_MEDIA {
      gathered[m] = mean_seen * column[m];
      matter += column[m];
    }
    seen = ends ? Spectrum(0.0f) : left;
    seen_mean = spectrum_mean(seen);
    // With some slack: rounding must not leave a quantum of nothing before the depth.
    if (full && seen_mean <= 0.50005f && result.depth > 1e29f) result.depth = walk.t;
    bool shades = matter > 0.0f;
    while (shades) {
      // The last quantum of a ray that leaves the media may end before that place: its centre, then.
      if (shading_t < 0.0f) shading_t = tau > 0.0f ? begin + moment / tau : 0.5f * (begin + walk.t);
      shade(scene, walk, gathered, origin, direction, shading_t, result);
      shades = false;
    }
    alive = alive && !ends;
  }
  result.transmittance = spectrum_rgb(seen);
  return result;
}

PLN_END
#endif
