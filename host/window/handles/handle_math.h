// From the way of the mouse to lengths, angles and factors: pure functions of where it was pressed and where
// it is, so that a drag never gathers errors.
//
// Points of the screen have x right, y down [points]. Lines of sight that graze what they are to meet are
// held back, so that all results are finite.
#pragma once

#include "host/window/overlay/projection.h"

namespace plinian::window {

/// How far along a line the mouse is: exact for what is seen of it, the foot of the mouse on the line's
/// picture. through: [world] in front of the camera. along: unit. reach: [world] > 0, a length in which the
/// line is straight to the eye, as a handle's. Returns [world]; 0 where the line points at the viewer. At the
/// line's vanishing point it is held at 20 times the depth.
double along_line(const Projection& projection, const dvec3& through, const dvec3& along, double reach,
                  dvec2 mouse);

/// How far a line of sight is from lying in a plane, and a line from pointing at the viewer: [0, 1], the sine
/// of the angle between them.
double openness_of_plane(const Projection& projection, const dvec3& through, const dvec3& normal);
double openness_of_line(const Projection& projection, const dvec3& through, const dvec3& along);

/// Where a line of sight meets a plane [world]; not beyond 20 times the depth of `through`.
dvec3 on_plane(const Projection& projection, const dvec3& through, const dvec3& normal, dvec2 mouse);

/// Where the mouse is in the plane through a point that is parallel to the picture [world].
dvec3 beside_point(const Projection& projection, const dvec3& through, dvec2 mouse);

/// The turn [degrees] about an axis that takes what is seen at `from` to `to`: exact in the plane of the
/// ring; where that is seen from the side, as far as the mouse went along the ring. radius: [world] of the
/// ring. near: the turn is the one that comes nearest to it, of all that look the same.
double ring_turn(const Projection& projection, const dvec3& centre, const dvec3& axis, double radius,
                 dvec2 from, dvec2 to, double near);

/// ... about the line of sight through the centre; positive is against the clock.
double view_turn(const Projection& projection, const dvec3& centre, dvec2 from, dvec2 to, double near);

/// The power of ten that is not above `size`, for values that read well. size: > 0
double round_step(double size);

/// The whole multiple of a step that is nearest to a value, without what binary fractions add.
double rounded(double value, double step);

}  // namespace plinian::window
