// Values of the shared maths for C++ and GLSL to agree on: function number k at x in [0, 1].
#include "core/shared/blackbody_lookup.h"
#include "core/shared/cosine_texel.h"
#include "core/shared/light_falloff.h"
#include "core/shared/phase.h"
#include "core/shared/view_curve.h"

PLN_BEGIN

PLN_CONST int parity_functions = 14;

PLN_FN float parity_value(int k, float x) {
  float c = 2.0f * x - 1.0f;
  if (k == 0) return henyey_greenstein(c, 0.7f);
  if (k == 1) return schlick_phase(c, -0.4f);
  if (k == 2) return phase_function(phase_two_lobe, c, 0.6f, -0.3f, 0.25f);
  if (k == 3) return cos_pi(x);
  if (k == 4) return bounds_k_min(pack_bounds(x * 3.0f, x * 3.0f + 0.5f, true, 4.0f), 4.0f);
  if (k == 5) return bounds_k_max(pack_bounds(x * 3.0f, x * 3.0f + 0.5f, false, 4.0f), 4.0f);
  if (k == 6) return distance_falloff(falloff_inverse_square, x * 4.0f, 0.3f);
  if (k == 7) return distance_falloff(falloff_linear, x * 4.0f, 0.3f);
  if (k == 8)
    return spot_edge(vec3(0.0f, 0.0f, 1.0f), normalize(vec3(x, 0.2f, 1.0f)), squared_chord(0.3f),
                     squared_chord(0.6f));
  if (k == 9) return blackbody_position(300.0f + 13000.0f * x);
  if (k == 10) return blackbody_gain(3000.0f * x);
  if (k == 11) return srgb_from_linear(x);
  if (k == 12) return linear_from_srgb(x);
  return filmic_curve(8.0f * x);
}

PLN_END
