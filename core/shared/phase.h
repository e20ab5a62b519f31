// Phase functions: isotropic, Henyey-Greenstein, Schlick, two-lobe Henyey-Greenstein [CGLearn].
//
// Convention, here and everywhere: cos_theta is the cosine between the direction that light travels before
// the scattering event and the one after it, so 1 is straight on and g > 0 scatters forward. Every function
// integrates to one over the sphere [1/sr].
#ifndef PLINIAN_SHARED_PHASE_H
#define PLINIAN_SHARED_PHASE_H
#include "core/shared/glue.h"
PLN_BEGIN

PLN_CONST float inverse_four_pi = 0.07957747154594767f;  // [1/sr]

PLN_CONST int phase_isotropic = 0;
PLN_CONST int phase_henyey_greenstein = 1;
PLN_CONST int phase_schlick = 2;
PLN_CONST int phase_two_lobe = 3;

/// Henyey-Greenstein phase function [CGLearn]. g: [-] in (-1, 1), the mean cosine. Returns [1/sr].
PLN_FN float henyey_greenstein(float cos_theta, float g) {
  float denominator = max(1.0f + g * g - 2.0f * g * cos_theta, 1e-6f);
  return inverse_four_pi * (1.0f - g * g) / (denominator * sqrt(denominator));
}

/// Schlick's rational approximation of Henyey-Greenstein [CGLearn]. g is turned into Schlick's k by
/// k = 1.55 g - 0.55 g^3 (Blasi, Le Saec, Schlick 1993). Returns [1/sr].
PLN_FN float schlick_phase(float cos_theta, float g) {
  float k = 1.55f * g - 0.55f * g * g * g;
  float denominator = max(1.0f - k * cos_theta, 1e-6f);
  return inverse_four_pi * (1.0f - k * k) / (denominator * denominator);
}

/// Any of the phase functions by kind. g_back and blend are read by the two-lobe function alone: a share
/// `blend` [-] in [0, 1] of the light scatters with g_back instead of g. Returns [1/sr].
PLN_FN float phase_function(int kind, float cos_theta, float g, float g_back, float blend) {
  if (kind == phase_henyey_greenstein) return henyey_greenstein(cos_theta, g);
  if (kind == phase_schlick) return schlick_phase(cos_theta, g);
  if (kind == phase_two_lobe)
    return mix(henyey_greenstein(cos_theta, g), henyey_greenstein(cos_theta, g_back), blend);
  return inverse_four_pi;
}

PLN_END
#endif
