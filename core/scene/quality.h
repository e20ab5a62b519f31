// Everything that trades time for quality, in one value: what a preset file holds.
#pragma once

#include <string>

namespace plinian {

enum class Encoding {
  tfm,   // cosine series over the whole ray [TFM11]
  atfm,  // cosine series over the range in which light dies [ATFM13 Algorithm 2]
};

/// Where an adaptive map's range begins.
enum class KminRule {
  first_density,  // at the first non-zero sample, as published [ATFM13 Algorithm 2]
  veil_proof,     // where T falls under kmin_transmittance: a thin veil in front does not widen the range
};

/// What an adaptive map says behind kmax of a dense texel.
enum class EndRule {
  zero,        // nothing gets through
  last_value,  // the series' own value at its end, as the published text reads; leaks light
};

/// Where shading points get their light from.
enum class LightLookup {
  map,    // decoded from a transmittance map
  march,  // a march to the light from every shading point: the honest yardstick for the maps' speed
  error,  // no light: each light's layer holds |T of a march - T of its maps|, weighted by opacity
};

struct MapQuality {
  Encoding encoding = Encoding::atfm;
  int coefficients = 6;     // [2, 16] cosine terms per texel
  float threshold = 0.02f;  // [-] (0, 1): transmittance under which a ray counts as dead
  KminRule kmin_rule = KminRule::veil_proof;
  float kmin_transmittance = 0.97f;  // [-] (0, 1]
  EndRule end_rule = EndRule::zero;
  float density_weighting = 2.0f;  // [-] >= 1: T^(1/w) is stored [TFM11 eq. 19-20]; 1 turns it off
  int resolution = 512;            // texels along a side of a light's view
  float detect_step = 2.0f;        // [voxels] between density samples in thin matter
  int refine_steps = 64;           // samples of the second march
};

struct ViewQuality {
  int shade_samples = 8;               // light lookups along an opaque view ray, placed at equal opacity
  float step = 2.0f;                   // [voxels] between density samples in thin matter
  float transmittance_cutoff = 0.01f;  // [-] a ray ends where nothing more than this could be seen
  int passes = 32;                     // jittered passes of a picture at most
  float rest_change = 2.0f;            // [8-bit steps] >= 0: a picture with no more change to come is at rest
  bool exact_light_at_rest = false;    // further passes at rest replace map lookups by the light march
  LightLookup light = LightLookup::map;
  float march_step = 1.0f;   // [voxels] of a marched light ray
  float march_depth = 5.0f;  // [-] optical depth at which a marched light ray ends
};

/// Whether passes beyond the first of a picture march to the light.
inline bool has_exact_passes(const ViewQuality& view, int passes) {
  return view.exact_light_at_rest && passes > 1 && view.light != LightLookup::error;
}

struct Quality {
  std::string name = "fast";
  MapQuality map;
  ViewQuality view;
};

}  // namespace plinian
