// What of the selection a tool moves: where it stands, and why some of it cannot be moved.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/placement.h"
#include "host/graph/commands/session.h"
#include "host/window/handles/handle_shape.h"

namespace plinian::window {

struct TargetNode {
  graph::NodeId id;
  std::string name;
  Placement placement;
  dmat4 world_from_parent{1.0};

  /// The point that turning and scaling leave where it is. [world]
  dvec3 centre() const;
  /// Which way its own axes point, unit columns. turning: as a rotation does, else as its parents stretch
  /// them.
  dmat3 own_axes(bool turning) const;
  /// What its attributes become. way: [world]. axis: [world] unit. factors: of its own axes.
  dvec3 moved(const dvec3& way) const;
  dvec3 turned(const dvec3& axis, double degrees) const;
  dvec3 scaled(const dvec3& factors) const;
};

struct HandleTarget {
  std::vector<TargetNode> nodes;  // the first leads: the one that was selected last
  HandlePlace place;              // without its radius
  Tool tool = Tool::select;
  AxisSpace space = AxisSpace::world;
};

/// Whether a tool has something to do with nodes of a type that have a place: a sun has no place to be moved
/// to, a point no direction.
bool tool_fits(Tool tool, const std::string& node_type);

/// What of the selection stands under nothing else of it; of shapes, which have no place of their own, what
/// they are under. None where the tool has nothing to take hold of.
std::optional<HandleTarget> handle_target(graph::Session& session, const ToolChoice& choice);

/// "translate", "rotate" or "scale".
const char* attribute_of(Tool tool);

/// The components of that attribute that dragging a part of the handles changes.
std::array<bool, 3> components_of(const HandleTarget& target, const TargetNode& node, Part part);

/// Why a node cannot follow a part of the handles, in a line; empty where it can.
std::string target_problem(graph::Session& session, const HandleTarget& target, const TargetNode& node,
                           Part part);

}  // namespace plinian::window
