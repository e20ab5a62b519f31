// Nodes whose type comes or goes while a scene is open: with its plug-in.
#pragma once

#include <string>
#include <vector>

#include "host/graph/edits/editor.h"

namespace plinian::graph {

/// Makes nodes of a type that was unknown what they were, connections and all, once the type is registered.
/// Returns warnings about lines that still mean nothing.
std::vector<std::string> revive_nodes(Editor& editor, const NodeTypePtr& type);

/// Turns the nodes of a type into unknown ones that keep every line and connection. Steps of undo still hold
/// nodes of it.
void forget_type(Editor& editor, const NodeTypePtr& type);

/// Gives values of a data type back to the nodes that kept them as lines, once the type is registered.
std::vector<std::string> revive_data(Editor& editor, const std::string& data_type);

/// Turns values of a data type into lines that their nodes keep, before the type goes. Steps of undo still
/// hold such values.
void forget_data(Editor& editor, const std::string& data_type);

/// Resets attributes whose data cannot be written: for the end of a session, when nothing can be kept for
/// them.
void drop_unwritable_data(Editor& editor);

}  // namespace plinian::graph
