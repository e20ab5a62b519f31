// What a scene needs and does not find here.
#pragma once

#include <string>

#include "host/graph/model/graph.h"

namespace plinian::scene {

/// Which nodes are of types that are not known, and the plug-ins that they need: "2 nodes of the type
/// 'cloudShape' need the plug-in 'cloudmaker'". Empty where every type is known. Such nodes may be shapes, so
/// that a picture without them is not the scene's.
std::string missing_types(const graph::Graph& graph);

/// The node of an unknown type that a node takes anything from, directly or by way of others, or null.
const graph::Node* unknown_source(const graph::Graph& graph, graph::NodeId node);

}  // namespace plinian::scene
