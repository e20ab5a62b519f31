#include "host/window/navigation/light_stand.h"

#include "host/graph/model/hierarchy.h"

namespace plinian::window {

namespace {

using Value = std::function<double(const graph::Plug&)>;

// What of a placement turns.
Placement turning_placement(const graph::Node& node, const Value& value) {
  const auto number = [&](const std::string& name, double otherwise) {
    const graph::AttributeIndex index = node.schema->find(name);
    return index == graph::no_attribute ? otherwise : value({node.id, index});
  };
  Placement placement;
  for (int i = 0; i < 3; ++i) {
    placement.rotate[i] = number(std::string("rotate.") + "xyz"[i], 0.0);
    placement.scale[i] = number(std::string("scale.") + "xyz"[i], 1.0);
  }
  placement.order = RotateOrder(int(number("rotate_order", 0.0)));
  return placement;
}

}  // namespace

LightStand light_stand(const graph::Graph& graph, const graph::Node& light, const Value& value) {
  LightStand stand{turning_placement(light, value)};
  for (const graph::NodeId above : graph::ancestors(graph, light.id))
    stand.world_from_parent =
        matrix_of(turning_placement(*graph.find(above), value)) * stand.world_from_parent;
  return stand;
}

}  // namespace plinian::window
