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
  std::vector<NodeId> shared;         // that were there and are shared: of their types a scene has one
};

/// Adds the nodes of a scene to the graph as one step of undo. name: the file's, for messages; name_space:
/// goes before the names of the nodes ("" for none). Throws GraphError, with file and line, and changes
/// nothing, for a damaged scene.
SceneReport read_scene(std::string_view text, const std::string& name, const TypeRegistry& registry,
                       Editor& editor, const std::string& name_space = "");

/// What a scene says it needs. Throws as read_scene does.
struct RequiredPlugin {
  std::string name, version;
};
std::vector<RequiredPlugin> required_plugins(std::string_view text, const std::string& name);

/// What it means for the scene that the plug-in is there in another version, as for a newer format: a newer
/// minor version was needed and a warning is added, or a newer major one and the scene is read-only as well.
void compare_version(const RequiredPlugin& required, const std::string& version, const std::string& name,
                     SceneReport& report);

/// The text of a file. Throws GraphError where it cannot be read or is larger than any scene (1 GiB).
std::string read_text_file(const std::string& path);

}  // namespace plinian::graph
