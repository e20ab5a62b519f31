// A camera that shows all of the media, from a direction that flatters a column of ash.
#pragma once

#include <string>
#include <vector>

#include "core/media/medium.h"
#include "core/scene/camera.h"

namespace plinian {

/// What a camera and lights are to be placed around.
struct SceneBounds {
  std::vector<dvec3> outline;         // [world] points whose convex hull holds every medium
  dvec3 minimum{-1.0}, maximum{1.0};  // [world] axis-parallel box; of the unit cube where there is nothing
  dvec3 centre() const { return (minimum + maximum) * 0.5; }
  double radius() const { return glm::length(maximum - minimum) * 0.5; }
};

/// Bricks that hold density, and analytic shapes. Empty media count for nothing.
SceneBounds scene_bounds(const std::vector<Medium>& media);

/// How large they are and where their middle is: "2.1 x 3 x 2 m at (0, 1.5, 0)".
std::string extent_text(const SceneBounds& bounds);

/// Direction from the middle of the media to the camera or a light [-] unit. azimuth: [degrees] 0 from +z, 90
/// from +x; elevation: [degrees] 90 from above (+y).
dvec3 direction_from(double azimuth, double elevation);

struct SkyAngles {
  double azimuth = 0.0;    // [degrees] in [-180, 180]: 0 from +z, 90 from +x
  double elevation = 0.0;  // [degrees] in [-90, 90]: 90 from above (+y)
};
/// The angles by which direction_from gives a direction. toward: [world] not 0. right: [world] to the right
/// of what looks back from there, which tells the azimuth straight above and below.
SkyAngles angles_of_direction(const dvec3& toward, const dvec3& right);

/// The view direction of a bare volume: three quarters from the front; level or slightly from below for what
/// stands upright, so that a column towers, and from above for what lies flat.
inline constexpr double default_azimuth = 30.0;  // [degrees]
double default_elevation(const SceneBounds& bounds);

/// Moves a camera (its lens is kept) to where every point of the outline is in a picture of width x height
/// pixels, filling `fill` [-] in (0, 1] of it in the tighter direction.
Camera frame_bounds(Camera lens, const SceneBounds& bounds, double azimuth, double elevation, int width,
                    int height, double fill = 0.86);

}  // namespace plinian
