// A light shines along its -z: it comes from its +z.
#include "host/window/navigation/light_angles.h"

#include <algorithm>
#include <cmath>

#include "host/graph/values/value_text.h"

namespace plinian::window {

namespace {

// Whether it is turned about y after x: then y is its azimuth and x its elevation.
bool turns_x_first(RotateOrder order) {
  return order == RotateOrder::xyz || order == RotateOrder::zxy || order == RotateOrder::xzy;
}

// A mirrored light shines the other way.
double sign_of(const Placement& placement) {
  return placement.scale.z < 0.0 ? -1.0 : 1.0;
}

}  // namespace

bool has_direction(const std::string& node_type) {
  return node_type == "directionalLight" || node_type == "spotLight";
}

std::optional<SkyAngles> sky_angles(const Placement& placement, const dmat4& world_from_parent) {
  const dmat3 own(matrix_of({.rotate = placement.rotate, .order = placement.order}));
  const dmat3 parent(world_from_parent);
  const dvec3 toward = parent * own[2] * sign_of(placement);
  const double determinant = std::abs(glm::determinant(parent));
  const double size = glm::length(parent[0]) * glm::length(parent[1]) * glm::length(parent[2]);
  if (!(determinant > 1e-9 * size)) return std::nullopt;
  return angles_of_direction(toward, parent * own[0]);
}

dvec3 rotation_toward(const SkyAngles& angles, const Placement& placement, const dmat4& world_from_parent) {
  const bool is_free = dmat3(world_from_parent) == dmat3(1.0) && sign_of(placement) > 0.0;
  dvec3 rotation(0.0);
  if (turns_x_first(placement.order) && is_free) {
    rotation = {-angles.elevation, angles.azimuth, 0.0};  // exact, and straight above too
  } else {
    const dvec3 own = glm::normalize(glm::inverse(dmat3(world_from_parent)) *
                                     direction_from(angles.azimuth, angles.elevation)) *
                      sign_of(placement);
    rotation = turns_x_first(placement.order)
                   ? angles_toward(own)
                   : dvec3(glm::degrees(std::atan2(-own.y, own.z)),
                           glm::degrees(std::asin(std::clamp(own.x, -1.0, 1.0))), 0.0);
  }
  rotation.y += 360.0 * std::round((placement.rotate.y - rotation.y) / 360.0);
  rotation = glm::round(rotation * 1e4) / 1e4 + 0.0;  // no -0
  for (int i = 0; i < 3; ++i)
    if (std::abs(rotation[i] - placement.rotate[i]) < 1e-4) rotation[i] = placement.rotate[i];
  return rotation;
}

std::string rotate_line(const std::string& node, const dvec3& rotation) {
  return "setAttr " + node + ".rotate " + graph::write_number(rotation.x) + " " +
         graph::write_number(rotation.y) + " " + graph::write_number(rotation.z);
}

std::optional<std::string> rotate_line(const std::string& node, const dvec3& before, const dvec3& after) {
  const glm::bvec3 changes = glm::greaterThan(glm::abs(after - before), dvec3(1e-7));
  if (!glm::any(changes)) return std::nullopt;
  for (int i = 0; i < 3; ++i)
    if (changes == glm::bvec3(i == 0, i == 1, i == 2))
      return "setAttr " + node + ".rotate." + "xyz"[i] + " " + graph::write_number(after[i]);
  return rotate_line(node, after);
}

}  // namespace plinian::window
