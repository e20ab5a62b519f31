// Azimuth and elevation of where light comes from.
#include "host/window/navigation/key_light.h"

#include <algorithm>

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

std::optional<dvec3> turned_light(const LightStand& stand, dvec2 points) {
  std::optional<SkyAngles> angles = sky_angles(stand.placement, stand.world_from_parent);
  if (!angles) return std::nullopt;
  angles->azimuth += points.x * degrees_per_point;
  angles->elevation = std::clamp(angles->elevation - points.y * degrees_per_point, -89.0, 89.0);
  // Round, so that the command reads well.
  return glm::round(rotation_toward(*angles, stand.placement, stand.world_from_parent) * 100.0) / 100.0;
}

}  // namespace plinian::window
