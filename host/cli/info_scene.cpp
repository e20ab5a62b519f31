// Opens a scene and lists its nodes.
#include "host/cli/info_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/cli/console.h"
#include "host/scene/workspace.h"

namespace plinian::cli {

using nlohmann::ordered_json;

namespace {

// What a node's attributes of the kind name, as typed.
std::vector<std::string> files_of(const graph::Node& node) {
  std::vector<std::string> files;
  for (const graph::StoredValue& stored : node.values)
    if ((*node.schema)[stored.attribute].spec.type == graph::AttributeType::path)
      if (const std::string& file = std::get<std::string>(stored.value); !file.empty()) files.push_back(file);
  return files;
}

}  // namespace

std::string scene_info(const std::string& path, bool json) {
  scene::Workspace workspace;
  graph::Session& session = workspace.session();
  session.on_warning = [](const std::string& line) { warn(line); };
  session.open_scene(path);
  const graph::Graph& graph = session.graph();
  ordered_json nodes = ordered_json::array();
  std::size_t name_width = 0, type_width = 0;
  for (const graph::Node* node : graph.nodes()) {
    const graph::Node* parent = node->parent ? graph.find(node->parent) : nullptr;
    nodes.push_back({{"name", node->name},
                     {"type", node->type->name()},
                     {"known", !node->type->is_unknown()},
                     {"under", parent ? ordered_json(parent->name) : ordered_json(nullptr)},
                     {"files", files_of(*node)}});
    name_width = std::max(name_width, node->name.size());
    type_width = std::max(type_width, node->type->name().size());
  }
  if (json)
    return ordered_json{{"path", path}, {"kind", "scene"}, {"nodes", nodes}}.dump(
               2, ' ', false, ordered_json::error_handler_t::replace) +
           "\n";
  std::string text = fmt::format("{}: a scene of {} nodes\n", path, nodes.size());
  for (const ordered_json& node : nodes) {
    std::string line = fmt::format("  {:<{}}  {:<{}}", node["name"].get<std::string>(), name_width,
                                   node["type"].get<std::string>(), type_width);
    if (!node["under"].is_null()) line += "  under " + node["under"].get<std::string>();
    for (const ordered_json& file : node["files"]) line += "  " + file.get<std::string>();
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace plinian::cli
