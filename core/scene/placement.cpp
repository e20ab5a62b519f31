// Matrices from angles and back.
#include "core/scene/placement.h"

#include <cmath>

namespace plinian {

namespace {

// Sine and cosine of an angle [degrees]; a quarter turn has no sixteenths of an ulp in it.
void sine_cosine(double degrees, double& sine, double& cosine) {
  const double quarters = degrees / 90.0;
  if (quarters == std::floor(quarters) && std::abs(quarters) < 1e9) {
    const int quarter = int(((long long)(quarters) % 4 + 4) % 4);
    sine = quarter == 1 ? 1.0 : quarter == 3 ? -1.0 : 0.0;
    cosine = quarter == 0 ? 1.0 : quarter == 2 ? -1.0 : 0.0;
    return;
  }
  sine = std::sin(glm::radians(degrees));
  cosine = std::cos(glm::radians(degrees));
}

dmat4 rotation_about(int axis, double degrees) {
  double s = 0.0, c = 1.0;
  sine_cosine(degrees, s, c);
  if (axis == 0) return dmat4(dvec4(1, 0, 0, 0), dvec4(0, c, s, 0), dvec4(0, -s, c, 0), dvec4(0, 0, 0, 1));
  if (axis == 1) return dmat4(dvec4(c, 0, -s, 0), dvec4(0, 1, 0, 0), dvec4(s, 0, c, 0), dvec4(0, 0, 0, 1));
  return dmat4(dvec4(c, s, 0, 0), dvec4(-s, c, 0, 0), dvec4(0, 0, 1, 0), dvec4(0, 0, 0, 1));
}

// The axis that is turned about first, second and third.
constexpr int axes_of[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};

}  // namespace

std::vector<std::string> rotate_order_names() {
  return {"xyz", "yzx", "zxy", "xzy", "yxz", "zyx"};
}

dmat4 matrix_of(const Placement& placement) {
  const int* axes = axes_of[int(placement.order)];
  dmat4 matrix = rotation_about(axes[2], placement.rotate[axes[2]]) *
                 rotation_about(axes[1], placement.rotate[axes[1]]) *
                 rotation_about(axes[0], placement.rotate[axes[0]]);
  for (int i = 0; i < 3; ++i) matrix[i] *= placement.scale[i];
  dvec3 origin = placement.translate;
  if (placement.pivot != dvec3(0.0)) origin += placement.pivot - dmat3(matrix) * placement.pivot;
  matrix[3] = dvec4(origin, 1.0);
  return matrix;
}

dmat4 rotation_xyz(const dvec3& degrees) {
  return matrix_of({.rotate = degrees});
}

dvec3 angles_of(const dmat4& m) {
  // rotation_xyz is Z Y X, whose first column is (cy cz, cy sz, -sy).
  const double across = std::hypot(m[0].x, m[0].y);
  // Looking straight along x, x and z turn about the same line: all of it is given to x.
  if (across < 1e-12)
    return glm::degrees(dvec3(std::atan2(-m[2].y, m[1].y), std::atan2(-m[0].z, across), 0.0));
  // With a negative cosine of y the other two turn by half a turn more: what shows upright things upright
  // is the one of these with the lesser z, where 150 60 180 is -30 120 0.
  const auto with = [&](double sign) {
    return glm::degrees(dvec3(std::atan2(sign * m[1].z, sign * m[2].z), std::atan2(-m[0].z, sign * across),
                              std::atan2(sign * m[0].y, sign * m[0].x))) +
           0.0;  // no -0
  };
  const dvec3 plain = with(1.0), other = with(-1.0);
  return std::abs(other.z) < std::abs(plain.z) ? other : plain;
}

dvec3 angles_toward(const dvec3& direction) {
  const double across = std::hypot(direction.x, direction.z);
  return {glm::degrees(std::atan2(-direction.y, across)),
          across > 0.0 ? glm::degrees(std::atan2(direction.x, direction.z)) : 0.0, 0.0};
}

}  // namespace plinian
