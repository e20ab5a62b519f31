// The artist's own camera: tumbles about, tracks beside and dollies towards a point of interest, as Maya's
// does. Pure maths; it is no part of the scene.
#pragma once

#include "core/scene/camera.h"
#include "core/scene/framing.h"

namespace plinian::window {

struct FreeCamera {
  Camera lens;                            // whose place does not count
  dvec3 interest{0.0};                    // [world] what it turns about
  double azimuth = 0.0, elevation = 0.0;  // [degrees] from the interest to the camera, as direction_from
  double roll = 0.0;                      // [degrees] about the line of sight
  double distance = 1.0;                  // [world] > 0 from the interest to the camera

  /// The camera that the renderer takes.
  Camera camera() const;
};

/// The free camera that stands where `camera` stands; its point of interest is that far ahead. distance:
/// [world] > 0.
FreeCamera free_camera_at(const Camera& camera, double distance);

/// Where a camera's point of interest is best put: as far ahead as the middle of the bounds, not nearer than
/// a tenth of their radius. [world]
double interest_distance(const Camera& camera, const SceneBounds& bounds);

/// Turns about the interest. delta: [points] of the mouse, x right, y down. The elevation stays within
/// +-89.9 degrees, so that up stays up.
FreeCamera tumble(FreeCamera camera, dvec2 delta);

/// Moves so that what is at the distance of the interest follows the mouse. pane: [points] of the picture.
FreeCamera track(FreeCamera camera, dvec2 delta, ivec2 pane);

/// Goes nearer (> 0) or farther: a hundred points of the mouse, or seven notches of its wheel, halve or
/// double the distance. points: [points]
FreeCamera dolly(FreeCamera camera, double points);

/// Shows everything in the bounds, seen from the same side. pane: [pixels] of the picture.
FreeCamera frame(FreeCamera camera, const SceneBounds& bounds, ivec2 pane);

/// Whether a camera stands and looks as frame() would have it.
bool is_framed(const Camera& camera, const SceneBounds& bounds, ivec2 pane);

}  // namespace plinian::window
