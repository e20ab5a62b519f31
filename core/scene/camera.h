// A perspective camera with Maya's parameters.
#pragma once

#include "core/shared/glue.h"

namespace plinian {

/// How the film back meets a picture of another shape: `fill` crops the film, `overscan` shows more than it,
/// `horizontal` and `vertical` keep that side.
enum class FilmFit { fill, horizontal, vertical, overscan };

struct Camera {
  dmat4 world_from_camera{1.0};  // rigid; looks along -z, +y up, as in Maya and OpenGL
  float focal_length = 35.0f;    // [mm] > 0
  vec2 film_back{36.0f, 24.0f};  // [mm] horizontal, vertical aperture, > 0
  FilmFit fit = FilmFit::fill;
  vec2 film_offset{0.0f};     // [mm] shift of the film; +x shows more of what lies to the right
  float pixel_aspect = 1.0f;  // [-] width of a pixel over its height
  float near_clip = 0.0f;     // [world] distance along the ray below which nothing is seen
};

/// A pin-hole's rays: pixel centre (x + 0.5, y + 0.5), y down from the top row, has the direction
/// normalize(forward + (2 (x+0.5)/width - 1) * right + (1 - 2 (y+0.5)/height) * up).
struct CameraRays {
  vec3 origin;   // [world]
  vec3 forward;  // [world] unit
  vec3 right;    // [world] half the picture's width at distance 1, film offset aside
  vec3 up;       // [world] half the picture's height at distance 1
};
/// `forward` carries the film offset, so it need not be perpendicular to the others.
CameraRays camera_rays(const Camera& camera, int width, int height);

/// A camera at `eye` that looks at `target`, with a vertical field of view [degrees] for pictures of any
/// shape (FilmFit::vertical). Throws std::invalid_argument where eye and target coincide.
Camera look_at(dvec3 eye, dvec3 target, dvec3 up, double fov_y_degrees);

}  // namespace plinian
