// Whether one attribute may drive another, asked before it is tried.
#pragma once

#include <string>

#include "host/graph/model/graph.h"

namespace plinian::graph {

/// Why Editor::connect would refuse, in one line; empty where it would not. replace: what drives the
/// destination already is taken over. The cost is that of cycle_through.
std::string connect_problem(const Graph& graph, const Plug& source, const Plug& destination, bool replace);

/// The plug itself; of an array without an element the next free one.
Plug next_free(const Graph& graph, Plug destination);

}  // namespace plinian::graph
