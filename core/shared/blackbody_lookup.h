// Where a temperature lies in the table of Planck colours (core/media/blackbody.h), and how radiance grows
// with it. CPU and GPU read the same table in the same way, so that they emit the same light.
#ifndef PLINIAN_SHARED_BLACKBODY_LOOKUP_H
#define PLINIAN_SHARED_BLACKBODY_LOOKUP_H
#include "core/shared/glue.h"
PLN_BEGIN

PLN_CONST int blackbody_entries = 512;
PLN_CONST float blackbody_first = 500.0f;   // [K] temperature of entry 0
PLN_CONST float blackbody_last = 12000.0f;  // [K] temperature of the last entry

/// Position of a temperature [K] in the table, clamped to its ends; the colour is the linear blend of the
/// entries on both sides. Returns [entries] in [0, blackbody_entries - 1].
PLN_FN float blackbody_position(float kelvin) {
  float x = (kelvin - blackbody_first) / (blackbody_last - blackbody_first);
  return x > 0.0f ? min(x, 1.0f) * float(blackbody_entries - 1) : 0.0f;  // not a number reads entry 0
}

/// Stefan-Boltzmann growth of emitted radiance with temperature, one at 1800 K: (T/1800)^4. Returns [-] >= 0.
PLN_FN float blackbody_gain(float kelvin) {
  float x = kelvin > 0.0f ? kelvin / 1800.0f : 0.0f;
  return x * x * x * x;
}

PLN_END
#endif
