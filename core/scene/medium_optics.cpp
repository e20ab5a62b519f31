// Pairs of coefficients, either way round.
#include "core/scene/medium_optics.h"

namespace plinian {

void set_optics(const MediumDescription& d, Medium& medium) {
  const vec3 extinction = d.extinction.value_or(medium.sigma_s + medium.sigma_a);
  vec3 albedo(0.0f);
  for (int i = 0; i < 3; ++i) {
    const float sum = medium.sigma_s[i] + medium.sigma_a[i];
    albedo[i] = d.albedo ? (*d.albedo)[i] : sum > 0.0f ? medium.sigma_s[i] / sum : 0.0f;
  }
  if (d.albedo || d.extinction) {
    medium.sigma_s = extinction * albedo;
    medium.sigma_a = extinction * (vec3(1.0f) - albedo);
  }
  medium.sigma_s = d.sigma_s.value_or(medium.sigma_s);
  medium.sigma_a = d.sigma_a.value_or(medium.sigma_a);

  if (d.g) medium.phase.g = *d.g;
  if (d.g_back) medium.phase.g_back = *d.g_back;
  if (d.blend) medium.phase.blend = *d.blend;
  if (d.phase)
    medium.phase.kind = *d.phase;
  else if (d.g && medium.phase.kind == PhaseKind::isotropic && *d.g != 0.0f)
    medium.phase.kind = PhaseKind::henyey_greenstein;

  if (d.emission_scale) medium.emission.scale = *d.emission_scale;
  if (d.emission_exposure) medium.emission.exposure = *d.emission_exposure;
}

}  // namespace plinian
