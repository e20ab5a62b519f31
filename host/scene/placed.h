// Where nodes stand in the world and whether they are seen, with what drives them taken into account.
#pragma once

#include <set>

#include "core/scene/placement.h"
#include "core/shared/glue.h"
#include "host/graph/evaluation/evaluator.h"
#include "host/graph/model/graph.h"

namespace plinian::scene {

/// Reads inputs of nodes at the current time; what is not driven costs no evaluation.
class Placed {
 public:
  Placed(const graph::Graph& graph, graph::Evaluator& evaluator) : graph_(graph), evaluator_(evaluator) {}

  /// The value of an input. Throws GraphError where what drives it failed.
  graph::Value value(const graph::Plug& plug) const;
  double number(const graph::Plug& plug) const;
  /// The attribute of that path, of a type that has it. Throws GraphError.
  graph::Plug plug(const graph::Node& node, const std::string& path) const;

  /// world_from_own: the matrices of the node and of all that it is under, by the attributes translate,
  /// rotate, rotate_order, scale and pivot where a type has them.
  dmat4 world_matrix(graph::NodeId node) const;
  dmat4 local_matrix(const graph::Node& node) const { return matrix_of(placement(node)); }
  Placement placement(const graph::Node& node) const;

  /// Whether the node and all that it is under are visible and, where `isolated` is not empty, whether it is
  /// one of those, or above or under one.
  bool is_shown(graph::NodeId node, const std::set<graph::NodeId>& isolated) const;

 private:
  const graph::Graph& graph_;
  graph::Evaluator& evaluator_;
};

}  // namespace plinian::scene
