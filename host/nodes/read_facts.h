// What a volumeRead says of the file that it shows, for whoever sets a scene up from it.
#pragma once

#include <string>

#include "core/media/vdb_reader.h"
#include "host/graph/values/value.h"

namespace plinian::nodes {

/// The data type of its output `facts`; the object is a VdbFacts, without path where nothing is shown.
inline constexpr const char* facts_type = "file_facts";

/// What a reader of files advises for a command line, "--level-set fog converts it", for the attributes of
/// the node that reads: "attribute level_set fog converts it"; and back.
std::string advice_for_node(std::string text);
std::string advice_for_command_line(std::string text);

}  // namespace plinian::nodes
