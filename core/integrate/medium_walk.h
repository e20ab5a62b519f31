// A ray's way through one medium, piece by piece, exactly: what the offline reference measures density with.
//
// Trilinear density along a straight line is a cubic inside each cell of the grid, and constant inside the
// analytic shapes, so a ray is a list of cubics and optical depths are sums of their integrals: no step size,
// no error beyond rounding. The map-based renderers share nothing with this file; it is the truth that they
// are measured against.
#pragma once

#include <algorithm>
#include <vector>

#include "core/media/medium.h"

namespace plinian {

struct Ray {
  dvec3 origin;     // [world]
  dvec3 direction;  // [-] unit
};

/// Density along a part of a ray: c[0] + c[1] s + c[2] s^2 + c[3] s^3 with s = (t - begin) / (end - begin).
struct DensityPiece {
  double begin, end;  // [world] distance along the ray
  double c[4];        // [unit of the file]

  double share(double t) const { return (t - begin) / (end - begin); }

  /// Density at a distance t in [begin, end] [unit of the file], >= 0.
  double density(double t) const {
    const double s = share(t);
    return std::max(0.0, c[0] + s * (c[1] + s * (c[2] + s * c[3])));
  }

  /// Integral of density from `begin` to t [unit of the file * world].
  double integral(double t) const {
    const double s = share(t);
    return (end - begin) * s * (c[0] + s * (c[1] / 2 + s * (c[2] / 3 + s * c[3] / 4)));
  }
};

class MediumWalk {
 public:
  /// Keeps a pointer to the volume, not to the medium. Throws std::invalid_argument naming the medium where
  /// its transform cannot be inverted or it has no volume.
  explicit MediumWalk(const Medium& medium);

  /// Appends the pieces between two distances where density is not zero everywhere, in order and disjoint.
  /// Ends once the integral of density [unit of the file * world] has passed `enough`.
  void pieces(const Ray& ray, double begin, double end, double enough, std::vector<DensityPiece>& out) const;

  /// Integral of density between two distances [unit of the file * world]; once past `enough` it ends there.
  double integral(const Ray& ray, double begin, double end, double enough) const;

  /// Length of one voxel along a direction [world]; the analytic shapes count as 128 voxels across.
  double voxel_length(dvec3 world_direction) const;

  /// Stored temperature at a point [K]; zero for shapes and volumes without one.
  float stored_temperature(dvec3 world_position) const;
  bool has_temperature() const { return volume_ && !volume_->temperature.empty(); }

 private:
  bool shape_chord(const Ray& ray, double& begin, double& end) const;
  template <class Visit>
  void walk_voxels(const Ray& ray, double begin, double end, Visit visit) const;

  MediumShape shape_;
  const BrickVolume* volume_ = nullptr;
  dmat4 local_from_world_{1.0};  // index space for voxels, medium space for the shapes
};

}  // namespace plinian
