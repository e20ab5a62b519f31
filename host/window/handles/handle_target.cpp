// Places under parents, and the attributes that hold them.
#include "host/window/handles/handle_target.h"

#include <algorithm>
#include <cmath>

#include "core/scene/placement_angles.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/hierarchy.h"
#include "host/scene/placed.h"

namespace plinian::window {

namespace {

// A parent that is squeezed to nothing: its space cannot be got out of.
bool is_flat(const dmat4& world_from_parent) {
  const dmat3 m(world_from_parent);
  const double size = glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
  return !(std::abs(glm::determinant(m)) > 1e-9 * size);
}

bool has_place(const graph::Node& node) {
  for (const char* name : {"translate.x", "rotate.x", "scale.x"})
    if (node.schema->find(name) == graph::no_attribute) return false;
  return true;
}

// The node itself, or, of a shape, what it is under; 0 where there is no place.
graph::NodeId placed_node(const graph::Graph& graph, graph::NodeId id) {
  while (id && !has_place(*graph.find(id))) id = graph.find(id)->parent;
  return id;
}

// Without what rounding leaves on axes that are not meant.
dvec3 cleaned(dvec3 v) {
  const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  for (int i = 0; i < 3; ++i)
    if (std::abs(v[i]) < 1e-9 * size) v[i] = 0.0;
  return v;
}

}  // namespace

dvec3 TargetNode::centre() const {
  return dvec3(world_from_parent * dvec4(placement.translate + placement.pivot, 1.0));
}

dmat3 TargetNode::own_axes(bool turning) const {
  const dmat3 parent(world_from_parent);
  const dmat3 rotation(matrix_of({.rotate = placement.rotate, .order = placement.order}));
  if (is_flat(world_from_parent)) return rotation;
  dmat3 axes = (turning ? turning_part(parent) : parent) * rotation;
  for (int i = 0; i < 3; ++i) axes[i] = glm::normalize(axes[i]);
  return axes;
}

dvec3 TargetNode::moved(const dvec3& way) const {
  if (is_flat(world_from_parent)) return placement.translate;
  return placement.translate + cleaned(glm::inverse(dmat3(world_from_parent)) * way);
}

// Under a parent that stretches, what the parent does besides that is what a turn in the world goes through.
dvec3 TargetNode::turned(const dvec3& axis, double degrees) const {
  if (is_flat(world_from_parent) || degrees == 0.0) return placement.rotate;
  const dmat3 q = turning_part(dmat3(world_from_parent));
  const double hand = glm::determinant(q) < 0.0 ? -1.0 : 1.0;  // a mirror turns the other way round
  return turned_angles(placement.rotate, placement.order, glm::normalize(cleaned(glm::transpose(q) * axis)),
                       degrees * hand);
}

dvec3 TargetNode::scaled(const dvec3& factors) const {
  dvec3 result = placement.scale;
  for (int i = 0; i < 3; ++i)  // what is nothing, grows out of it
    result[i] = result[i] == 0.0 ? factors[i] - 1.0 : result[i] * factors[i];
  return result;
}

bool tool_fits(Tool tool, const std::string& node_type) {
  if (tool == Tool::select) return false;
  if (node_type == "directionalLight") return tool == Tool::rotate;
  if (node_type == "pointLight") return tool == Tool::translate;
  if (node_type == "spotLight" || node_type == "camera") return tool != Tool::scale;
  return true;
}

std::optional<HandleTarget> handle_target(graph::Session& session, const ToolChoice& choice) {
  const graph::Graph& graph = session.graph();
  std::vector<graph::NodeId> meant;  // the last that was selected first
  for (auto id = graph.selection().rbegin(); id != graph.selection().rend(); ++id)
    if (const graph::NodeId found = placed_node(graph, *id);
        found && std::find(meant.begin(), meant.end(), found) == meant.end())
      meant.push_back(found);
  HandleTarget target{.nodes = {}, .place = {}, .tool = choice.tool, .space = choice.space()};
  const scene::Placed placed(graph, session.evaluator());
  for (const graph::NodeId id : meant) {
    const graph::Node& node = *graph.find(id);
    if (!tool_fits(choice.tool, node.type->name())) continue;
    const auto above = graph::ancestors(graph, id);
    const bool is_carried = std::any_of(above.begin(), above.end(), [&](graph::NodeId parent) {
      return std::find(meant.begin(), meant.end(), parent) != meant.end();
    });
    if (is_carried) continue;
    try {
      TargetNode found{.id = id, .name = node.name, .placement = placed.placement(node)};
      if (node.parent) found.world_from_parent = placed.world_matrix(node.parent);
      target.nodes.push_back(std::move(found));
    } catch (const graph::GraphError&) {
      // What has no place has no handles; the outliner says why.
    }
  }
  if (target.nodes.empty()) return std::nullopt;
  target.place.centre = target.nodes[0].centre();
  if (target.space == AxisSpace::local)
    target.place.axes = target.nodes[0].own_axes(choice.tool == Tool::rotate);
  const double size = glm::length(target.place.centre);
  return std::isfinite(size) ? std::optional(std::move(target)) : std::nullopt;
}

const char* attribute_of(Tool tool) {
  return tool == Tool::rotate ? "rotate" : tool == Tool::scale ? "scale" : "translate";
}

std::array<bool, 3> components_of(const HandleTarget& target, const TargetNode& node, Part part) {
  std::array<bool, 3> changes{};
  const auto note = [&](const dvec3& after, const dvec3& before, double tolerance) {
    for (int i = 0; i < 3; ++i) changes[std::size_t(i)] |= std::abs(after[i] - before[i]) > tolerance;
  };
  const int axis = axis_of(part);
  if (target.tool == Tool::scale) {
    for (int i = 0; i < 3; ++i) changes[std::size_t(i)] = axis < 0 || axis == i;
  } else if (axis < 0) {
    changes = {true, true, true};
  } else if (target.tool == Tool::rotate) {
    const dvec3 along =
        target.space == AxisSpace::local ? node.own_axes(true)[axis] : target.place.axes[axis];
    for (const double degrees : {20.0, 75.0}) note(node.turned(along, degrees), node.placement.rotate, 1e-7);
  } else {
    for (int i = 0; i < 3; ++i)
      if (is_plane(part) != (i == axis)) {
        TargetNode at_home = node;
        at_home.placement.translate = dvec3(0.0);
        note(at_home.moved(target.place.axes[i]), dvec3(0.0), 0.0);
      }
  }
  return changes;
}

std::string target_problem(graph::Session& session, const HandleTarget& target, const TargetNode& node,
                           Part part) {
  if (is_flat(node.world_from_parent))
    return node.name + " cannot be moved by hand: what it is under is scaled to nothing";
  const graph::Node& found = *session.graph().find(node.id);
  const std::array<bool, 3> changes = components_of(target, node, part);
  for (int i = 0; i < 3; ++i) {
    if (!changes[std::size_t(i)]) continue;
    const graph::Plug plug =
        graph::Graph::plug(found, std::string(attribute_of(target.tool)) + "." + "xyz"[i]);
    if (const std::string problem = session.editor().set_problem({node.id, plug.attribute}); !problem.empty())
      return problem;
  }
  return "";
}

}  // namespace plinian::window
