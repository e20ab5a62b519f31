// The transform hierarchy: who is under whom, and what is shown.
#pragma once

#include <set>
#include <vector>

#include "host/graph/model/graph.h"

namespace plinian::graph {

/// Parents, the nearest first.
std::vector<NodeId> ancestors(const Graph& graph, NodeId node);

/// The nodes and everything under them, parents before children, each once.
std::vector<NodeId> with_descendants(const Graph& graph, const std::vector<NodeId>& nodes);

/// Name of the attribute by which a node hides itself and what is under it.
inline constexpr const char* visibility_attribute = "visibility";

/// That attribute, where there is one that says yes or no; else no_attribute.
AttributeIndex visibility_of(const Schema& schema);

/// Whether the node and all its parents are set to be visible. A connected visibility counts as what it is
/// set to; an evaluator knows better.
bool is_visible(const Graph& graph, NodeId node);

/// ... and, where `isolated` is not empty, whether the node is one of them, or above or under one.
bool is_shown(const Graph& graph, NodeId node, const std::set<NodeId>& isolated);

}  // namespace plinian::graph
