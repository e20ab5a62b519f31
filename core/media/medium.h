// A participating medium as a scene sees it: a shape of density, and the optical properties that scale with
// it.
//
// sigma_t(p) = density(p) * density_scale * (sigma_s + sigma_a)   [1/world unit], colours linear Rec.709.
#pragma once

#include <memory>
#include <string>

#include "core/media/brick_volume.h"

namespace plinian {

enum class MediumShape {
  voxels,  // a BrickVolume
  box,     // density 1 inside the unit cube [-1, 1]^3 of medium space
  sphere,  // density 1 inside the unit ball of medium space
};

enum class PhaseKind { isotropic, henyey_greenstein, schlick, two_lobe };  // values as in shared/phase.h

struct Phase {
  PhaseKind kind = PhaseKind::isotropic;
  float g = 0.0f;       // [-] in (-1, 1): mean cosine, > 0 scatters forward
  float g_back = 0.0f;  // [-] second lobe, two_lobe only
  float blend = 0.0f;   // [-] in [0, 1]: share of the second lobe
};

/// Thermal emission: radiance per length = density * density_scale * emission_scale * 2^emission_exposure *
/// (T/1800)^4 * planck_colour(T), the colour having luminance 1. T = temperature_offset + temperature_scale *
/// value.
struct Emission {
  float scale = 0.0f;     // [radiance per world unit at density * density_scale = 1 and T = 1800 K]; 0: none
  float exposure = 0.0f;  // [stops]
  float temperature_scale = 1.0f;   // [K per stored kelvin]; applied to what the volume stores
  float temperature_offset = 0.0f;  // [K]
};

struct Medium {
  std::string name = "medium";
  MediumShape shape = MediumShape::voxels;
  std::shared_ptr<const BrickVolume> volume;  // for MediumShape::voxels
  dmat4 world_from_medium{1.0};               // affine; may mirror or scale unevenly
  float density_scale = 1.0f;                 // [1 / unit of the file]
  vec3 sigma_s{0.8f};                         // [1/world unit] scattering at density * density_scale = 1
  vec3 sigma_a{0.2f};                         // [1/world unit] absorption, likewise
  Phase phase;
  Emission emission;
};

}  // namespace plinian
