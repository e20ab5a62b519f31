// Rotations under parents, and the angles that make them.
#pragma once

#include "core/scene/placement.h"

namespace plinian::window {

/// The orthonormal matrix that is nearest to a regular one (its polar factor): how it turns, and mirrors,
/// what it also stretches.
dmat3 turning_part(const dmat3& matrix);

/// The angles [degrees] that make a rotation in an order: of all that do, those nearest to `near`.
dvec3 angles_of(const dmat3& rotation, RotateOrder order, const dvec3& near);

/// The angles of what stood at `start` and is turned about an axis of its parent's space. axis: unit. turn:
/// [degrees], against the clock seen from the tip of the axis. Several turns count as such.
dvec3 turned_angles(const dvec3& start, RotateOrder order, const dvec3& axis, double turn);

}  // namespace plinian::window
