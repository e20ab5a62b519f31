// Why a pixel looks as it does: what its ray meets, and how a light fades on its way to a point of that ray,
// exactly and as the light's transmittance map has it.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "core/integrate/flat_scene.h"
#include "core/scene/snapshot.h"

namespace plinian {

/// What the ray through a pixel meets.
struct ViewRayProbe {
  struct Sample {
    double t;             // [world] distance from the camera
    dvec3 sigma_t;        // [1/world] extinction of all media
    dvec3 transmittance;  // [-] from the camera
  };
  dvec3 origin, direction;      // [world], [-] unit
  std::vector<Sample> samples;  // evenly from the first density to the last; empty where there is none
  double depth;                 // [world] where alpha passes 0.5; infinity if it never does
  dvec3 at(double t) const { return origin + t * direction; }
  /// Where lights are probed unless somebody says otherwise: at the depth, or else half way through. samples:
  /// not empty.
  double middle() const {
    return std::isfinite(depth) ? depth : 0.5 * (samples.front().t + samples.back().t);
  }
};

/// How one light fades along the ray on which it travels to a point.
struct LightRayProbe {
  struct Sample {
    double k;  // [world] see MapData: distance from a lamp, or from the near plane of a directional one
    dvec3 exact, map;  // [-] transmittance from the light
  };
  /// Bounds of the nearest texel of one colour group's map.
  struct Bounds {
    double k_min, k_max;  // [world]; in front of k_min all light arrives
    bool dense;           // none arrives behind k_max; else what is left there goes on
    bool missed;          // the texel's ray meets no medium
  };
  std::string light;
  double k;                     // [world] of the point
  dvec3 exact, map;             // [-] at the point; the map's as a picture reads it, between four texels
  std::vector<Sample> samples;  // evenly, from before the light fades to behind the point and all bounds
  std::vector<Bounds> bounds;   // by colour group
};

/// Looks into one scene. Keeps pointers to its volumes. Exact values are those of the offline reference
/// (medium_walk.h); maps are marched as scene.quality says, a few texels at a time.
class RayProbe {
 public:
  /// Throws as flatten() does.
  explicit RayProbe(const SceneSnapshot& scene);

  /// pixel: from the upper left corner. count: of samples, at least 2.
  ViewRayProbe view_ray(ivec2 pixel, int count = 256) const;
  /// light: index in scene.lights. Throws std::out_of_range where there is no such light.
  LightRayProbe light_ray(const dvec3& point, std::size_t light, int count = 256) const;

 private:
  SceneSnapshot scene_;
  FlatScene flat_;
};

}  // namespace plinian
