// World matrices and visibility.
#include "host/scene/placed.h"

#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"
#include "host/graph/model/hierarchy.h"

namespace plinian::scene {

using graph::AttributeIndex;
using graph::Node;
using graph::NodeId;
using graph::Plug;
using graph::Value;

Value Placed::value(const Plug& plug) const {
  const Node& node = *graph_.find(plug.node);
  if (node.inputs_of(plug.attribute, plug.element).empty()) return node.value(plug.attribute, plug.element);
  const graph::ResultPtr result = evaluator_.evaluate(plug);
  if (result->error)
    throw graph::GraphError(graph_.name_of(plug) + ": " + evaluator_.error_text(plug, *result));
  return result->value;
}

double Placed::number(const Plug& plug) const {
  return graph::number_of(value(plug));
}

Plug Placed::plug(const Node& node, const std::string& path) const {
  return graph::Graph::plug(node, path);
}

Placement Placed::placement(const Node& node) const {
  const auto three = [&](const char* name, const dvec3& otherwise) {
    const AttributeIndex compound = node.schema->find(name);
    if (compound == graph::no_attribute || (*node.schema)[compound].children.size() != 3) return otherwise;
    dvec3 result;
    for (int i = 0; i < 3; ++i)
      result[i] = number({node.id, (*node.schema)[compound].children[std::size_t(i)]});
    return result;
  };
  Placement placement;
  placement.translate = three("translate", placement.translate);
  placement.rotate = three("rotate", placement.rotate);
  placement.scale = three("scale", placement.scale);
  placement.pivot = three("pivot", placement.pivot);
  if (const AttributeIndex order = node.schema->find("rotate_order"); order != graph::no_attribute)
    placement.order = RotateOrder(int(number({node.id, order})));
  return placement;
}

dmat4 Placed::world_matrix(NodeId id) const {
  dmat4 matrix = local_matrix(*graph_.find(id));
  for (const NodeId above : graph::ancestors(graph_, id)) matrix = local_matrix(*graph_.find(above)) * matrix;
  return matrix;
}

bool Placed::is_shown(NodeId id, const std::set<NodeId>& isolated) const {
  if (!isolated.empty() && !graph::is_shown(graph_, id, isolated)) return false;
  for (NodeId at = id; at; at = graph_.find(at)->parent) {
    const Node& node = *graph_.find(at);
    const AttributeIndex attribute = graph::visibility_of(*node.schema);
    if (attribute != graph::no_attribute && number({at, attribute}) == 0.0) return false;
  }
  return true;
}

}  // namespace plinian::scene
