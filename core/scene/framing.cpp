// Framing: bounds of the media and the exact distance at which they fill a picture.
#include "core/scene/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace plinian {

namespace {

// Visits the lower corner [index space] of every brick with density.
void for_each_brick(const BrickVolume& volume, const std::function<void(ivec3)>& visit) {
  const auto descend = [&](auto&& self, BrickEntry entry, int level, ivec3 corner) -> void {
    if (!(entry.x & BrickVolume::occupied_bit)) return;
    if (level == 0) return visit(corner);
    const int child_size = BrickVolume::brick_size << (3 * (level - 1));
    const std::size_t node = std::size_t(entry.x & ~BrickVolume::occupied_bit) * 512;
    for (int i = 0; i < 512; ++i)
      self(self, volume.nodes[node + std::size_t(i)], level - 1,
           corner + child_size * ivec3(i & 7, (i >> 3) & 7, i >> 6));
  };
  const ivec3 dims = volume.root_dims;
  for (int z = 0, i = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++i)
        descend(descend, volume.root[std::size_t(i)], volume.levels,
                volume.origin + volume.root_cell_size() * ivec3(x, y, z));
}

void add_box(std::vector<dvec3>& outline, const dmat4& world_from_space, const dvec3& low,
             const dvec3& high) {
  for (int i = 0; i < 8; ++i)
    outline.push_back(dvec3(world_from_space * dvec4(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
                                                     i & 4 ? high.z : low.z, 1.0)));
}

void add_medium(std::vector<dvec3>& outline, const Medium& medium) {
  if (medium.shape == MediumShape::box)
    return add_box(outline, medium.world_from_medium, dvec3(-1), dvec3(1));
  if (medium.shape == MediumShape::sphere) {
    const int rings = 24;  // within 1% of the ball
    for (int i = 0; i <= rings; ++i)
      for (int j = 0; j < 2 * rings; ++j)
        outline.push_back(dvec3(medium.world_from_medium *
                                dvec4(direction_from(180.0 * j / rings, 180.0 * i / rings - 90.0), 1.0)));
    return;
  }
  if (!medium.volume || medium.volume->empty()) return;
  const dmat4 world_from_index = medium.world_from_medium * medium.volume->medium_from_index;
  for_each_brick(*medium.volume, [&](ivec3 corner) {
    // A brick at the edge is mostly empty: its share of the volume's bounds is what can hold density.
    const dvec3 low = max(dvec3(corner), dvec3(medium.volume->bounds_min));
    const dvec3 high = min(dvec3(corner + BrickVolume::brick_size), dvec3(medium.volume->bounds_max));
    if (all(lessThanEqual(low, high))) add_box(outline, world_from_index, low, high);
  });
}

}  // namespace

SceneBounds scene_bounds(const std::vector<Medium>& media) {
  SceneBounds bounds;
  for (const Medium& medium : media) add_medium(bounds.outline, medium);
  if (bounds.outline.empty()) {
    add_box(bounds.outline, dmat4(1.0), bounds.minimum, bounds.maximum);
    return bounds;
  }
  bounds.minimum = bounds.maximum = bounds.outline.front();
  for (const dvec3& point : bounds.outline) {
    bounds.minimum = min(bounds.minimum, point);
    bounds.maximum = max(bounds.maximum, point);
  }
  return bounds;
}

std::string extent_text(const SceneBounds& bounds) {
  const dvec3 size = bounds.maximum - bounds.minimum, middle = bounds.centre();
  // Three figures are as many as one looks at: of each side, and of the place those of the largest side.
  const auto tidy = [](double value, double of) {
    const double step = std::pow(10.0, std::floor(std::log10(std::max(of, 1e-30))) - 2.0);
    return std::round(value / step) * step + 0.0;
  };
  const double largest = std::max({size.x, size.y, size.z});
  return fmt::format("{:.6g} x {:.6g} x {:.6g} m at ({:.6g}, {:.6g}, {:.6g})", tidy(size.x, size.x),
                     tidy(size.y, size.y), tidy(size.z, size.z), tidy(middle.x, largest),
                     tidy(middle.y, largest), tidy(middle.z, largest));
}

dvec3 direction_from(double azimuth, double elevation) {
  const double a = glm::radians(azimuth), e = glm::radians(elevation);
  return {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
}

SkyAngles angles_of_direction(const dvec3& toward, const dvec3& right) {
  const double across = std::hypot(toward.x, toward.z);
  const double azimuth =
      across > 1e-9 * glm::length(toward) ? std::atan2(toward.x, toward.z) : std::atan2(-right.z, right.x);
  return {glm::degrees(azimuth), glm::degrees(std::atan2(toward.y, across))};
}

double default_elevation(const SceneBounds& bounds) {
  const dvec3 size = bounds.maximum - bounds.minimum;
  const double upright = size.y / std::max({size.x, size.z, 1e-30});
  return glm::mix(14.0, -4.0, glm::smoothstep(0.4, 1.5, upright));
}

Camera frame_bounds(Camera lens, const SceneBounds& bounds, double azimuth, double elevation, int width,
                    int height, double fill) {
  const dvec3 centre = bounds.centre(), back = direction_from(azimuth, elevation);
  // Straight from above nothing is up but what the azimuth says.
  const double a = glm::radians(azimuth);
  const dvec3 up = std::hypot(back.x, back.z) > 1e-9
                       ? dvec3(0, 1, 0)
                       : dvec3(-std::sin(a), 0, -std::cos(a)) * glm::sign(back.y);
  Camera camera = look_at(centre + back, centre, up, 40.0);  // for its axes alone
  const dvec3 x(camera.world_from_camera[0]), y(camera.world_from_camera[1]), z(camera.world_from_camera[2]);

  lens.world_from_camera = dmat4(1.0);
  const CameraRays rays = camera_rays(lens, width, height);
  const double half[2] = {rays.right.x * fill, rays.up.y * fill}, shift[2] = {rays.forward.x, rays.forward.y};

  // With the camera at (cx, cy, d) along its axes, a point p is in the picture where
  // |p.x - cx - shift (d - p.z)| <= half (d - p.z): linear in cx and d, so each side of the picture is a
  // bound.
  double low[2], high[2], nearest = -1e300;
  for (int axis = 0; axis < 2; ++axis) low[axis] = high[axis] = -1e300;
  for (const dvec3& point : bounds.outline) {
    const dvec3 offset = point - centre;
    const double along[2] = {glm::dot(offset, x), glm::dot(offset, y)}, depth = glm::dot(offset, z);
    for (int axis = 0; axis < 2; ++axis) {
      high[axis] = std::max(high[axis], along[axis] + (half[axis] + shift[axis]) * depth);
      low[axis] = std::max(low[axis], -along[axis] + (half[axis] - shift[axis]) * depth);
    }
    nearest = std::max(nearest, depth);
  }
  double distance = nearest + 0.01 * std::max(bounds.radius(), 1e-6);
  for (int axis = 0; axis < 2; ++axis)
    distance = std::max(distance, (high[axis] + low[axis]) / (2.0 * half[axis]));
  dvec3 eye = centre + z * distance;
  eye += x * ((high[0] - low[0]) / 2.0 - shift[0] * distance) +
         y * ((high[1] - low[1]) / 2.0 - shift[1] * distance);
  lens.world_from_camera = dmat4(dvec4(x, 0), dvec4(y, 0), dvec4(z, 0), dvec4(eye, 1));
  return lens;
}

}  // namespace plinian
