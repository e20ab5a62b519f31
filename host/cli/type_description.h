// A node type and its attributes, for people and for scripts.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/graph/types/node_type.h"

namespace plinian::cli {

/// A line for the type and two for each attribute that is not hidden: name, type, unit, default, hard range,
/// ends and step of the slider, group, when it is shown; and help.
std::string type_text(const graph::NodeType& type);

/// The same for scripts. Values are spelled as in scenes; what an attribute has not is left out.
nlohmann::ordered_json type_json(const graph::NodeType& type);

}  // namespace plinian::cli
