// Polar factor by Newton's iteration [Higham 1986]; angles of any order by its first and last axis.
#include "core/scene/placement_angles.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace plinian {

namespace {

// The axis that is turned about first, second and third.
constexpr int axes_of[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};

dvec3 brought_near(dvec3 angles, const dvec3& near) {
  for (int i = 0; i < 3; ++i) angles[i] += 360.0 * std::round((near[i] - angles[i]) / 360.0);
  return angles;
}

double distance(const dvec3& a, const dvec3& b) {
  return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

dvec3 rounded(const dvec3& v, double per_unit) {
  return glm::round(v * per_unit) / per_unit + 0.0;  // no -0
}

}  // namespace

dvec3 tidied(const dvec3& v) {
  const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(size > 0.0)) return dvec3(0.0);
  return rounded(v, std::pow(10.0, std::clamp(11 - int(std::floor(std::log10(size))), 0, 300)));
}

dvec3 direction_of(const vec3& toward) {
  // Between the unit sphere and the box of what rounds to the vector, until both hold.
  dvec3 direction = glm::normalize(dvec3(toward));
  for (int turn = 0; turn < 1000 && vec3(direction) != toward; ++turn) {
    for (int i = 0; i < 3; ++i) {
      const double below = 0.5 * (double(std::nextafter(toward[i], -2.0f)) - double(toward[i]));
      const double above = 0.5 * (double(std::nextafter(toward[i], 2.0f)) - double(toward[i]));
      direction[i] =
          std::clamp(direction[i], double(toward[i]) + 0.9 * below, double(toward[i]) + 0.9 * above);
    }
    direction = glm::normalize(direction);
  }
  return direction;
}

dvec3 short_angles_toward(const vec3& toward) {
  const dvec3 angles = angles_toward(direction_of(toward));
  for (double per_degree = 1.0; per_degree < 1e12; per_degree *= 10.0) {
    const dvec3 shorter = rounded(angles, per_degree);
    if (vec3(dvec3(rotation_xyz(shorter)[2])) == toward) return shorter;
  }
  return angles;
}

dmat3 turning_part(const dmat3& matrix) {
  dmat3 q = matrix / std::cbrt(std::abs(glm::determinant(matrix)));
  for (int i = 0; i < 60; ++i) {
    const dmat3 next = 0.5 * (q + glm::transpose(glm::inverse(q)));
    double change = 0.0;
    for (int c = 0; c < 3; ++c) change = std::max(change, glm::length(next[c] - q[c]));
    q = next;
    if (change < 1e-14) break;
  }
  return q;
}

dvec3 angles_of(const dmat3& m, RotateOrder order, const dvec3& near) {
  const auto& [i, j, k] = axes_of[int(order)];
  const double sign = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;  // of the permutation
  // The last rotation is about k and the first about i: row k, column i holds the second angle alone.
  const double across = std::hypot(m[i][i], m[i][j]);
  const double second = std::atan2(-sign * m[i][k], across);
  dvec3 angles(0.0);
  if (across < 1e-9) {
    // The first and the last turn about the same line: the first stays as it was.
    const double first = glm::radians(near[i]);
    const dvec3 seen = m[j] * std::cos(first) - sign * m[k] * std::sin(first);
    // Without the first rotation column j is (-sin of the last) on i and (cos of the last) on j.
    angles[i] = near[i];
    angles[j] = glm::degrees(second);
    angles[k] = glm::degrees(std::atan2(-sign * seen[i], seen[j]));
    return brought_near(angles, near);
  }
  angles[i] = glm::degrees(std::atan2(sign * m[j][k], m[k][k]));
  angles[j] = glm::degrees(second);
  angles[k] = glm::degrees(std::atan2(sign * m[i][j], m[i][i]));
  dvec3 other = angles;
  other[i] += 180.0;
  other[j] = 180.0 - other[j];
  other[k] += 180.0;
  angles = brought_near(angles, near);
  other = brought_near(other, near);
  return distance(other, near) < distance(angles, near) ? other : angles;
}

dvec3 turned_angles(const dvec3& start, RotateOrder order, const dvec3& axis, double turn) {
  const dmat3 from(matrix_of({.rotate = start, .order = order}));
  const auto turned = [&](double degrees) {
    return dmat3(glm::rotate(dmat4(1.0), glm::radians(degrees), axis)) * from;
  };
  // In steps, so that each angle is the one that is reached on the way.
  const int steps = std::clamp(int(std::ceil(std::abs(turn) / 10.0)), 1, 4096);
  dvec3 angles = start;
  for (int s = 1; s <= steps; ++s) angles = angles_of(turned(turn * s / steps), order, angles);
  return angles;
}

std::optional<FoundPlacement> placement_of(const dmat4& parent_from_own, const Placement& like) {
  const dmat3 m(parent_from_own);
  dvec3 size(glm::length(m[0]), glm::length(m[1]), glm::length(m[2]));
  const double volume = size.x * size.y * size.z, determinant = glm::determinant(m);
  if (!(std::abs(determinant) > 1e-9 * volume)) return std::nullopt;
  // Which axes are mirrored is a matter of choice, but whether an odd number of them is.
  dvec3 sign(1.0);
  for (int i = 0; i < 3; ++i) sign[i] = like.scale[i] < 0.0 ? -1.0 : 1.0;
  if ((determinant < 0.0) != (sign.x * sign.y * sign.z < 0.0)) sign.x = -sign.x;
  dmat3 axes = m;
  double skew = 0.0;
  for (int i = 0; i < 3; ++i) axes[i] *= sign[i] / size[i];
  for (int i = 0; i < 3; ++i) skew = std::max(skew, std::abs(glm::dot(axes[i], axes[(i + 1) % 3])));
  FoundPlacement found{like, skew > 1e-9};
  if (found.sheared) {
    for (int i = 0; i < 3; ++i) axes[i] *= size[i];
    const dmat3 stretched = axes;
    axes = turning_part(axes);
    for (int i = 0; i < 3; ++i) size[i] = glm::dot(axes[i], stretched[i]);
  }
  Placement& placement = found.placement;
  placement.scale = tidied(size * sign);
  placement.rotate = tidied(angles_of(axes, like.order, like.rotate));
  placement.translate = dvec3(0.0);
  placement.translate = tidied(dvec3(parent_from_own[3]) - dvec3(matrix_of(placement)[3]));
  return found;
}

}  // namespace plinian
