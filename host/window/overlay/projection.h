// From the world to the screen, for what is drawn over a picture.
#pragma once

#include <optional>
#include <utility>

#include "core/scene/camera.h"

namespace plinian::window {

struct ScreenPoint {
  vec2 at{0.0f};       // [points]
  double depth = 0.0;  // [world] along the line of sight
};

class Projection {
 public:
  /// The camera's picture of width x height pixels, shown from `begin` on in `size` [points].
  Projection(const Camera& camera, int width, int height, vec2 begin, vec2 size);

  /// Where a point is seen, in the picture or beside it; none behind the near plane.
  std::optional<ScreenPoint> point(const dvec3& world) const;
  /// What of a line lies in the picture, [points]; none where nothing does.
  std::optional<std::pair<vec2, vec2>> line(const dvec3& from, const dvec3& to) const;
  /// The line of sight through a point of the screen [world], not of unit length.
  dvec3 direction(vec2 at) const;
  /// How long a point of the screen is at a depth > 0. [world]
  double length_of_point(double depth) const;

  const dvec3& eye() const { return eye_; }
  vec2 begin() const { return begin_; }
  vec2 size() const { return size_; }

 private:
  /// u s, v s, s: the point lies at u, v in [-1, 1] of the picture (v up) and the depth s.
  dvec3 homogeneous(const dvec3& world) const { return lens_from_world_ * (world - eye_); }
  vec2 screen(const dvec3& homogeneous) const;

  dvec3 eye_;              // [world]
  dmat3 world_from_lens_;  // columns: right, up, forward
  dmat3 lens_from_world_;
  vec2 begin_, size_;  // [points]
};

}  // namespace plinian::window
