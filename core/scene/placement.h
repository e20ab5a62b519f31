// Where something stands in the space around it, with Maya's parameters.
#pragma once

#include <string>
#include <vector>

#include "core/shared/glue.h"

namespace plinian {

/// The order in which the axes are turned about: `xyz` turns about x first.
enum class RotateOrder { xyz, yzx, zxy, xzy, yxz, zyx };

/// The orders as files spell them, in the order of the enumeration.
std::vector<std::string> rotate_order_names();

struct Placement {
  dvec3 translate{0.0};  // [parent]
  dvec3 rotate{0.0};     // [degrees] about each axis
  RotateOrder order = RotateOrder::xyz;
  dvec3 scale{1.0};  // [-] before it is turned; negative mirrors
  dvec3 pivot{0.0};  // [own space] the point that turning and scaling leave where it is
};

/// parent_from_own: scaled, then turned, about the pivot, then moved.
dmat4 matrix_of(const Placement& placement);

/// Rotation about x, then y, then z [degrees], as Maya's default order has it. Quarter turns are exact.
dmat4 rotation_xyz(const dvec3& degrees);

/// Angles [degrees] that rotation_xyz makes that rotation of. rotation: orthonormal, right-handed; its
/// translation is ignored. Of the two ways to say it, the one that turns less about z.
dvec3 angles_of(const dmat4& rotation);

/// Angles [degrees] about x and y that turn +z to the direction. direction: not 0.
dvec3 angles_toward(const dvec3& direction);

}  // namespace plinian
