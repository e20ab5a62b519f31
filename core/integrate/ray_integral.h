// Single scattering along one view ray, by brute force: the integrand of the offline reference.
//
//   radiance = integral of T_view(t) [ sum of sigma_s phase E T_light + sum of sigma_s L_a + emission ] dt
//
// Optical depths, of the view ray and of every light ray, are exact (medium_walk.h). What is left to a
// discretisation is the light that arrives along the view ray, J(t) = phase E T_light. The ray is cut at
// every cell, entry, exit, cone and light radius, grouped into steps bounded in length and optical depth, and
// in each step J is taken at the two nodes of the Gauss rule whose weight is sigma_s T_view itself. So a step
// is exact for a J that is cubic in t, however rough the medium or dense the step, and light is traced only
// where light is scattered. Where channels or media differ in a step, each gets the share of the two nodes
// that keeps a linear J exact. Halving the steps is the convergence control, see dual_march.h.
//
// Left out: multiple scattering, occluders, area lights.
#pragma once

#include <vector>

#include "core/integrate/reference_scene.h"

namespace plinian {

/// What one view ray gathers. All radiances without the background.
struct RayRadiance {
  dvec3 ambient, emission;
  dvec3 transmittance;        // [-] of the whole ray
  double depth;               // [world] where 1 - mean transmittance passes 0.5; infinity if it never does
  std::vector<dvec3> lights;  // in the order of the scene
  bool empty;                 // the ray met no medium: the values are exact
};

/// Integrates view rays. Holds scratch memory: one per thread.
class RayIntegral {
 public:
  explicit RayIntegral(const ReferenceScene& scene);

  /// Radiance along a ray from `near` [world] on, with steps of 2^-level times the scene's. The result is
  /// valid until the next call.
  const RayRadiance& integrate(const Ray& ray, double near, int level);

 private:
  /// Where the walk stands in one medium.
  struct Cursor {
    std::vector<DensityPiece> pieces;
    std::size_t next = 0;                  // first piece that does not end before the current interval
    const DensityPiece* active = nullptr;  // the piece that covers the current interval
  };
  /// Bounds on an interval of the ray.
  struct Limits {
    double length;         // [world]
    double optical_depth;  // [-]
    double light_share;    // [-] of the distance to the nearest point or spot light
  };

  void cut(const Ray& ray, double near);
  bool enter(double begin);
  dvec3 optical_depth(double t) const;
  bool fits(double begin, const dvec3& tau_begin, double end, const Limits& limits) const;
  void add(double begin, double end);
  void shade();
  double half_way(double begin, double end) const;

  const ReferenceScene& scene_;
  Ray ray_{};
  std::vector<Cursor> cursors_;      // one per medium
  std::vector<double> cuts_;         // [world] sorted
  dvec3 tau_passed_{0.0};            // [-] of the pieces that ended
  std::vector<double> node_t_;       // [world] quadrature nodes of the current step
  std::vector<dvec3> node_weights_;  // sigma_s T dt at each node, medium by medium
  RayRadiance result_;
};

}  // namespace plinian
