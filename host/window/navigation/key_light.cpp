// Azimuth and elevation of where light comes from.
#include "host/window/navigation/key_light.h"

#include <algorithm>
#include <cmath>

#include "core/scene/framing.h"
#include "core/scene/placement.h"
#include "host/graph/values/value_text.h"

namespace plinian::window {

namespace {

constexpr double degrees_per_point = 0.5;

bool can_be_turned(const graph::Node& node) {
  return node.type->name() == "directionalLight" || node.type->name() == "spotLight";
}

}  // namespace

graph::NodeId light_to_turn(const graph::Graph& graph) {
  for (const graph::NodeId id : graph.selection())
    if (can_be_turned(*graph.find(id))) return id;
  if (const graph::Node* key = graph.find("key"); key && can_be_turned(*key)) return key->id;
  for (const graph::Node* node : graph.nodes())
    if (can_be_turned(*node)) return node->id;
  return {};
}

dvec3 turned_light(const dvec3& rotation, dvec2 points) {
  const dvec3 toward(rotation_xyz(rotation)[2]);
  const double azimuth = glm::degrees(std::atan2(toward.x, toward.z)) + points.x * degrees_per_point;
  const double elevation = std::clamp(
      glm::degrees(std::asin(std::clamp(toward.y, -1.0, 1.0))) - points.y * degrees_per_point, -89.0, 89.0);
  const dvec3 turned = angles_toward(direction_from(azimuth, elevation));
  // Round, so that the command reads well.
  return glm::round(turned * 100.0) / 100.0;
}

std::string light_command(const std::string& node, const dvec3& rotation) {
  return "setAttr " + node + ".rotate " + graph::write_number(rotation.x) + " " +
         graph::write_number(rotation.y) + " " + graph::write_number(rotation.z);
}

}  // namespace plinian::window
