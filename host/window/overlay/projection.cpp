// The camera's rays, turned round.
#include "host/window/overlay/projection.h"

#include <algorithm>

namespace plinian::window {

namespace {

constexpr double nearest = 1e-5;  // [world] nothing is drawn before that depth

}  // namespace

Projection::Projection(const Camera& camera, int width, int height, vec2 begin, vec2 size)
    : begin_(begin), size_(size) {
  const CameraRays rays = camera_rays(camera, width, height);
  eye_ = dvec3(camera.world_from_camera[3]);
  world_from_lens_ = dmat3(dvec3(rays.right), dvec3(rays.up), dvec3(rays.forward));
  lens_from_world_ = glm::inverse(world_from_lens_);
}

vec2 Projection::screen(const dvec3& h) const {
  const dvec2 seen(h.x / h.z, h.y / h.z);
  return begin_ + size_ * vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y);
}

std::optional<ScreenPoint> Projection::point(const dvec3& world) const {
  const dvec3 h = homogeneous(world);
  if (!(h.z > nearest)) return std::nullopt;
  return ScreenPoint{screen(h), h.z};
}

// Against the five planes before the division, so that what is behind the eye never comes out in front.
std::optional<std::pair<vec2, vec2>> Projection::line(const dvec3& from, const dvec3& to) const {
  const dvec3 a = homogeneous(from), b = homogeneous(to);
  double begin = 0.0, end = 1.0;
  const auto keep = [&](double at_a, double at_b) {  // where the distance from a plane is >= 0
    if (at_a < 0.0 && at_b < 0.0) return false;
    if (at_a < 0.0) begin = std::max(begin, at_a / (at_a - at_b));
    if (at_b < 0.0) end = std::min(end, at_a / (at_a - at_b));
    return begin < end;
  };
  if (!keep(a.z - nearest, b.z - nearest) || !keep(a.z - a.x, b.z - b.x) || !keep(a.z + a.x, b.z + b.x) ||
      !keep(a.z - a.y, b.z - b.y) || !keep(a.z + a.y, b.z + b.y))
    return std::nullopt;
  return std::pair(screen(glm::mix(a, b, begin)), screen(glm::mix(a, b, end)));
}

dvec3 Projection::direction(vec2 at) const {
  const vec2 share = (at - begin_) / size_;
  return world_from_lens_ * dvec3(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y, 1.0);
}

double Projection::length_of_point(double depth) const {
  return 2.0 * depth * glm::length(world_from_lens_[1]) / size_.y;
}

}  // namespace plinian::window
