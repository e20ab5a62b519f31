// Turns, moves and frames.
#include "host/window/navigation/free_camera.h"

#include <algorithm>
#include <cmath>

namespace plinian::window {

namespace {

constexpr double degrees_per_point = 0.3;
constexpr double steepest = 89.9;  // [degrees] of elevation: straight above, a turn has no side

dmat4 turned(const FreeCamera& c) {
  const dmat4 about_y = glm::rotate(dmat4(1.0), glm::radians(c.azimuth), dvec3(0.0, 1.0, 0.0));
  const dmat4 about_x = glm::rotate(about_y, glm::radians(-c.elevation), dvec3(1.0, 0.0, 0.0));
  return glm::rotate(about_x, glm::radians(c.roll), dvec3(0.0, 0.0, 1.0));
}

}  // namespace

Camera FreeCamera::camera() const {
  Camera placed = lens;
  placed.world_from_camera = turned(*this);
  placed.world_from_camera[3] = dvec4(interest + dvec3(placed.world_from_camera[2]) * distance, 1.0);
  return placed;
}

FreeCamera free_camera_at(const Camera& camera, double distance) {
  const dvec3 back(camera.world_from_camera[2]);
  FreeCamera free;
  free.lens = camera;
  free.distance = distance;
  free.interest = dvec3(camera.world_from_camera[3]) - back * distance;
  const dvec3 right(camera.world_from_camera[0]);
  const SkyAngles angles = angles_of_direction(back, right);
  free.azimuth = angles.azimuth;
  free.elevation = angles.elevation;
  const dmat4 level = turned(free);
  free.roll = glm::degrees(std::atan2(glm::dot(right, dvec3(level[1])), glm::dot(right, dvec3(level[0]))));
  return free;
}

double interest_distance(const Camera& camera, const SceneBounds& bounds) {
  const dvec3 to_middle = bounds.centre() - dvec3(camera.world_from_camera[3]);
  const double ahead = -glm::dot(to_middle, dvec3(camera.world_from_camera[2]));
  return std::max({ahead, bounds.radius() * 0.1, 1e-3});
}

FreeCamera tumble(FreeCamera camera, dvec2 delta) {
  camera.azimuth = std::remainder(camera.azimuth - delta.x * degrees_per_point, 360.0);
  camera.elevation = std::clamp(camera.elevation + delta.y * degrees_per_point, -steepest, steepest);
  return camera;
}

FreeCamera track(FreeCamera camera, dvec2 delta, ivec2 pane) {
  const CameraRays rays = camera_rays(camera.camera(), pane.x, pane.y);
  const dvec3 right = dvec3(rays.right) * (2.0 / pane.x), up = dvec3(rays.up) * (2.0 / pane.y);
  camera.interest += (up * delta.y - right * delta.x) * camera.distance;
  return camera;
}

FreeCamera dolly(FreeCamera camera, double points) {
  constexpr double nearest = 1e-4, farthest = 1e7;
  camera.distance = std::clamp(camera.distance * std::exp2(-points / 100.0), nearest, farthest);
  return camera;
}

FreeCamera frame(FreeCamera camera, const SceneBounds& bounds, ivec2 pane) {
  const Camera framed = frame_bounds(camera.lens, bounds, camera.azimuth, camera.elevation, pane.x, pane.y);
  FreeCamera free = free_camera_at(framed, interest_distance(framed, bounds));
  free.azimuth = camera.azimuth;
  free.roll = 0.0;
  return free;
}

bool is_framed(const Camera& camera, const SceneBounds& bounds, ivec2 pane) {
  const FreeCamera here = free_camera_at(camera, interest_distance(camera, bounds));
  const dmat4 framed = frame(here, bounds, pane).camera().world_from_camera;
  const dmat4& now = camera.world_from_camera;
  constexpr double near = 1e-3;  // [-] of the distance, and of a radian
  for (int axis = 0; axis < 3; ++axis)
    if (glm::distance(glm::normalize(dvec3(now[axis])), dvec3(framed[axis])) > near) return false;
  return glm::distance(dvec3(now[3]), dvec3(framed[3])) < near * here.distance;
}

}  // namespace plinian::window
