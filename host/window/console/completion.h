// What a command line may go on with.
#pragma once

#include <string>
#include <vector>

#include "host/graph/commands/session.h"

namespace plinian::window {

struct Completion {
  std::size_t begin = 0;           // of the word that is completed, in the line
  std::vector<std::string> words;  // that it may become, sorted
  std::string common;              // what all of them begin with; at least the word itself
};

/// Completes the last word of the line: commands, flags, nodes, attributes (behind a dot), node types.
Completion complete(graph::Session& session, const std::string& line);

}  // namespace plinian::window
