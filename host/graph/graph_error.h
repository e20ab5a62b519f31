// What the graph, its commands and its files throw when they are asked for something that cannot be.
#pragma once

#include <stdexcept>

namespace plinian::graph {

/// One clear line: the node, attribute, file or command concerned, the reason, and what to do.
struct GraphError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace plinian::graph
