// What failed when a node was computed last.
#pragma once

#include <optional>
#include <string>

#include "host/graph/commands/session.h"

namespace plinian::window {

struct NodeFailure {
  std::string message;   // one line
  bool blocked = false;  // by another node's failure
};

/// Of the last computation of any output of a node; computes nothing.
std::optional<NodeFailure> failure_of(const graph::Session& session, graph::NodeId node);

}  // namespace plinian::window
