// Reads scene files into a graph.
//
// A scene is data: nothing in it is executed. What is not understood, because a plug-in is missing or older,
// is kept word for word and said once; only what no scene could hold is refused.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/graph/edits/editor.h"
#include "host/graph/types/type_registry.h"

namespace plinian::graph {

struct SceneReport {
  std::vector<std::string> warnings;  // one line each
  bool read_only = false;             // made by a newer major version: must not be saved over
  std::vector<NodeId> nodes;          // that were read, in the order of the file
};

/// Adds the nodes of a scene to the graph as one step of undo. name: the file's, for messages; name_space:
/// goes before the names of the nodes ("" for none). Throws GraphError, with file and line, and changes
/// nothing, for a damaged scene.
SceneReport read_scene(std::string_view text, const std::string& name, const TypeRegistry& registry,
                       Editor& editor, const std::string& name_space = "");

/// Names of the plug-ins that a scene says it needs. Throws as read_scene does.
std::vector<std::string> required_plugins(std::string_view text, const std::string& name);

/// The text of a file. Throws GraphError where it cannot be read or is larger than any scene (1 GiB).
std::string read_text_file(const std::string& path);

}  // namespace plinian::graph
