// What the nodes that read volumes have to say of the moment that is on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/graph/commands/session.h"

namespace plinian::cli {

std::vector<const graph::Node*> volume_readers(const graph::Graph& graph);

/// The value of an output; empty where it failed.
std::optional<graph::Value> reader_output(graph::Session& session, const graph::Node& reader,
                                          const char* output);

/// Why something else is shown than what was asked for: "medium_file: frame 2 is missing".
std::vector<std::string> reader_badges(graph::Session& session);

/// Those of them whose file is not there or cannot be read, and which nobody asked to fill its place.
std::vector<std::string> missing_files(graph::Session& session);

}  // namespace plinian::cli
