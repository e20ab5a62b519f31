#include "core/integrate/media_pixels.h"

#include <algorithm>
#include <cmath>

namespace plinian {
namespace {

/// The corners of a medium's bounds [world].
void add_corners(const MediumData& medium, std::vector<dvec3>& corners) {
  const auto row = [](vec4 r) { return dvec4(r); };
  const dmat4 local_from_world =
      glm::transpose(dmat4(row(medium.local_from_world_x), row(medium.local_from_world_y),
                           row(medium.local_from_world_z), dvec4(0.0, 0.0, 0.0, 1.0)));
  const dmat4 world_from_local = glm::inverse(local_from_world);
  for (int i = 0; i < 8; ++i) {
    const dvec3 share(i & 1, (i >> 1) & 1, i >> 2);
    const dvec3 local = glm::mix(dvec3(medium.bounds_min), dvec3(medium.bounds_max), share);
    corners.push_back(dvec3(world_from_local * dvec4(local, 1.0)));
  }
}

}  // namespace

PixelBox media_pixels(const FlatScene& flat, const Camera& camera, int width, int height) {
  const PixelBox whole{{0, 0}, {width, height}};
  std::vector<dvec3> corners;
  for (const MediumData& medium : flat.media) add_corners(medium, corners);
  const CameraRays rays = camera_rays(camera, width, height);
  // A point at origin + z (forward + x right + y up) is seen at (x, y) in [-1, 1]^2.
  const dmat3 picture_from_world = glm::inverse(dmat3(rays.right, rays.up, rays.forward));
  dvec2 low(HUGE_VAL), high(-HUGE_VAL);
  for (const dvec3& corner : corners) {
    const dvec3 away = corner - dvec3(rays.origin);
    const dvec3 seen = picture_from_world * away;
    if (!(seen.z > 1e-3 * glm::length(away))) return whole;
    const dvec2 pixel((0.5 + 0.5 * seen.x / seen.z) * width, (0.5 - 0.5 * seen.y / seen.z) * height);
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
  const auto clamped = [&](dvec2 p) { return ivec2(glm::clamp(p, dvec2(0.0), dvec2(width, height))); };
  const ivec2 first = clamped(glm::floor(low) - 1.0), last = clamped(glm::ceil(high) + 1.0);
  return {first, glm::max(last - first, ivec2(0))};
}

}  // namespace plinian
