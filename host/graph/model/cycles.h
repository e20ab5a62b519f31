// Whether a connection would close a cycle.
#pragma once

#include <string>
#include <vector>

#include "host/graph/model/graph.h"

namespace plinian::graph {

/// The way from `destination` through what it affects and drives back to `source`, both included; empty where
/// there is none, so that connecting them is safe. The cost is that of the smaller side: what the destination
/// drives or what the source depends on.
std::vector<Plug> cycle_through(const Graph& graph, const Plug& source, const Plug& destination);

/// "a.in -> a.out -> b.in -> b.out".
std::string describe_path(const Graph& graph, const std::vector<Plug>& path);

}  // namespace plinian::graph
