// Azimuth and elevation of where light comes from.
#include "host/window/navigation/key_light.h"

#include <algorithm>

#include "core/scene/placement.h"
#include "host/graph/values/value_text.h"
#include "host/window/navigation/light_angles.h"

namespace plinian::window {

namespace {

constexpr double degrees_per_point = 0.5;

bool can_be_turned(const graph::Node& node) {
  return has_direction(node.type->name());
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
  const Placement placement{.rotate = rotation};
  SkyAngles angles = sky_angles(placement, dmat4(1.0)).value();
  angles.azimuth += points.x * degrees_per_point;
  angles.elevation = std::clamp(angles.elevation - points.y * degrees_per_point, -89.0, 89.0);
  // Round, so that the command reads well.
  return glm::round(rotation_toward(angles, placement, dmat4(1.0)) * 100.0) / 100.0;
}

std::string light_command(const std::string& node, const dvec3& rotation) {
  return "setAttr " + node + ".rotate " + graph::write_number(rotation.x) + " " +
         graph::write_number(rotation.y) + " " + graph::write_number(rotation.z);
}

}  // namespace plinian::window
