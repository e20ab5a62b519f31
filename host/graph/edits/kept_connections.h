// Connections that are kept as a scene file has them, because a node of an unknown type is at their other
// end.
#pragma once

#include <string>
#include <vector>

#include "host/graph/model/graph.h"

namespace plinian::graph {

/// Those that end at an attribute, at a part of it or at what it is a part of: their places in Node::kept.
std::vector<std::size_t> kept_connections_into(const Node& node, const Plug& plug);

/// "fog1.other", that a kept connection comes from.
std::string kept_source_name(const Graph& graph, const KeptLine& line);

}  // namespace plinian::graph
