// How dense a volume should look whose file does not say: density has no unit in the wild, so a bare volume
// gets the scale at which the median optical depth through its silhouette is 12.
//
// The silhouette is seen along the three axes of the volume's own space, so that the answer depends neither
// on a camera nor on which way is up; rays are spaced evenly over all three views and pooled.
#pragma once

#include "core/media/medium.h"

namespace plinian {

/// What the rays through a volume met; lengths in world units under the given transform.
struct DensityFacts {
  float median_column =
      0.0f;  // [unit of the file * world] median line integral of density over the silhouette
  float typical_density =
      0.0f;      // [unit of the file] mean of the density that a ray meets, weighted by density
  int rays = 0;  // that met any density
};

/// Deterministic. world_from_medium: affine. An empty volume gives zeros.
DensityFacts measure_density(const BrickVolume& volume, const dmat4& world_from_medium);

/// The density_scale [1 / unit of the file] that makes the median optical depth through the silhouette
/// `optical_depth` where sigma_s + sigma_a is 1. An empty volume gets 1.
float automatic_density_scale(const BrickVolume& volume, const dmat4& world_from_medium,
                              float optical_depth = 12.0f);

/// Mean distance [world] between two events at a density [unit of the file]: 1 / sigma_t per colour channel,
/// infinite where sigma_t is 0.
vec3 mean_free_path(const Medium& medium, float density);

/// What stays as it is when a volume is scaled in space.
enum class Keep {
  extinction,     // sigma_t: a larger cloud is a denser one to look through
  optical_depth,  // the look: sigma_t falls as the size grows
};

/// Scales a medium about its own origin. factor: > 0, finite. Throws std::invalid_argument.
void rescale_volume(Medium& medium, double factor, Keep keep);

}  // namespace plinian
