// The camera's film geometry.
#include "core/scene/camera.h"

#include <cmath>
#include <stdexcept>

namespace plinian {

CameraRays camera_rays(const Camera& camera, int width, int height) {
  // Half extents of the film that the picture shows, at distance 1.
  double half_x = 0.5 * camera.film_back.x / camera.focal_length;
  double half_y = 0.5 * camera.film_back.y / camera.focal_length;
  const double picture_aspect = double(width) * camera.pixel_aspect / height;
  const double film_aspect = double(camera.film_back.x) / camera.film_back.y;
  bool keep_width = picture_aspect > film_aspect;  // fill: the picture lies inside the film
  if (camera.fit == FilmFit::overscan) keep_width = !keep_width;
  if (camera.fit == FilmFit::horizontal) keep_width = true;
  if (camera.fit == FilmFit::vertical) keep_width = false;
  if (keep_width)
    half_y = half_x / picture_aspect;
  else
    half_x = half_y * picture_aspect;

  const dvec3 x(camera.world_from_camera[0]), y(camera.world_from_camera[1]), z(camera.world_from_camera[2]);
  const dvec3 shift = x * double(camera.film_offset.x / camera.focal_length) +
                      y * double(camera.film_offset.y / camera.focal_length);
  return {vec3(dvec3(camera.world_from_camera[3])), vec3(shift - z), vec3(x * half_x), vec3(y * half_y)};
}

Camera look_at(dvec3 eye, dvec3 target, dvec3 up, double fov_y_degrees) {
  const dvec3 back = eye - target;
  if (!(glm::length(back) > 0.0)) throw std::invalid_argument("camera: eye and target are the same point");
  const dvec3 z = glm::normalize(back);
  // An up vector along the line of sight leaves the roll open: take the axis that is furthest from it.
  if (glm::length(glm::cross(up, z)) < 1e-9 * glm::length(up) || glm::length(up) == 0.0)
    up = std::abs(z.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(0, 0, -1);
  const dvec3 x = glm::normalize(glm::cross(up, z));
  Camera camera;
  camera.world_from_camera = dmat4(dvec4(x, 0), dvec4(glm::cross(z, x), 0), dvec4(z, 0), dvec4(eye, 1));
  camera.film_back = vec2(36.0f, 24.0f);
  camera.focal_length = float(12.0 / std::tan(glm::radians(fov_y_degrees) / 2.0));
  camera.fit = FilmFit::vertical;
  return camera;
}

}  // namespace plinian
