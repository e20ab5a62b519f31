// Media and lights prepared for the offline reference, and the light that arrives at a point through the
// media. Leaves out occluders and scattering on the way.
#pragma once

#include <vector>

#include "core/integrate/medium_walk.h"
#include "core/scene/snapshot.h"

namespace plinian {

/// How coarse a march starts and where rays end.
struct MarchSteps {
  double length = 4.0;          // [voxels] longest step
  double optical_depth = 1.0;   // [-] largest step, in the densest channel that still lets light through
  double light_distance = 1.0;  // [-] longest step over the distance to a point or spot light
  double growth = 0.25;         // [-] both grow by e^(growth tau) at an optical depth tau from the eye
  double light_cutoff = 20.0;   // [-] a light ray ends at this optical depth, T = 2e-9
  double view_cutoff = 1e-6;    // [-] a view ray ends at this transmittance
};

/// A snapshot prepared for marching; immutable, shared by all threads.
class ReferenceScene {
 public:
  /// Keeps pointers to the snapshot's volumes. Throws std::invalid_argument for a medium that cannot be
  /// walked or a light without a direction.
  ReferenceScene(const SceneSnapshot& scene, const MarchSteps& steps);

  struct MediumOptics {
    MediumWalk walk;
    dvec3 extinction;           // [1/world] per unit of the file's density
    dvec3 scattering;           // [1/world] likewise
    double emission;            // [radiance/world] likewise, at 1800 K
    double weakest_extinction;  // [1/world] likewise, of the channel that lets most through
    Phase phase;
    float temperature_scale, temperature_offset;
  };
  struct LightOptics {
    LightType type;
    dvec3 power;                  // irradiance facing a directional light, or at distance 1
    dvec3 toward;                 // [-] unit, directional and spot
    dvec3 position;               // [world]
    int falloff;                  // shared::falloff_*
    float radius;                 // [world]
    double cos_inner, cos_outer;  // [-] of a spot's cone
    float inner_squared_chord, outer_squared_chord;  // [-] likewise, for shared::spot_edge
    bool dark;                                       // no channel has any power
  };

  std::vector<MediumOptics> media;
  std::vector<LightOptics> lights;
  dvec3 ambient;  // [radiance]
  MarchSteps steps;

  /// Light arriving at a point from one light.
  struct Arrival {
    dvec3 irradiance;  // facing the light, shadowed by the media
    dvec3 toward;      // [-] unit, to the light
  };
  Arrival arrival(const LightOptics& light, dvec3 point) const;

  /// Transmittance along a ray between 0 and a distance, per channel [-].
  dvec3 transmittance(const Ray& ray, double distance) const;
};

}  // namespace plinian
