// From matrices back to placements: rotations, and the angles that make them.
#pragma once

#include <optional>

#include "core/scene/placement.h"

namespace plinian {

/// Without what a matrix and its inverse leave behind the digits that are meant: 12 digits of the largest.
dvec3 tidied(const dvec3& v);

/// The direction of which a vector of floats is the rounding: a unit vector that rounds to it where there is
/// one. toward: not 0.
dvec3 direction_of(const vec3& toward);

/// The shortest angles [degrees] about x and y that turn +z to a direction as it is in floats: -42, not
/// -42.000001061274496. toward: unit.
dvec3 short_angles_toward(const vec3& toward);

/// The orthonormal matrix that is nearest to a regular one (its polar factor): how it turns, and mirrors,
/// what it also stretches.
dmat3 turning_part(const dmat3& matrix);

/// The angles [degrees] that make a rotation in an order: of all that do, those nearest to `near`.
dvec3 angles_of(const dmat3& rotation, RotateOrder order, const dvec3& near);

/// The angles of what stood at `start` and is turned about an axis of its parent's space. axis: unit. turn:
/// [degrees], against the clock seen from the tip of the axis. Several turns count as such.
dvec3 turned_angles(const dvec3& start, RotateOrder order, const dvec3& axis, double turn);

/// The placement that makes a matrix, in the order and about the pivot of `like`, with the angles and signs
/// of the scale that are nearest to its own. Numbers are rounded to 12 digits, so that they read well.
struct FoundPlacement {
  Placement placement;
  bool sheared = false;  // the matrix also shears, which no placement does: this is the nearest one
};
/// Empty where the matrix squeezes a direction to nothing. parent_from_own: affine.
std::optional<FoundPlacement> placement_of(const dmat4& parent_from_own, const Placement& like);

}  // namespace plinian
