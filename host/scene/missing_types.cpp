// Counts nodes of unknown types.
#include "host/scene/missing_types.h"

#include <fmt/format.h>

#include <map>

namespace plinian::scene {

std::string missing_types(const graph::Graph& graph) {
  std::map<std::string, int> counts;
  for (const graph::Node* node : graph.nodes())
    if (node->type->is_unknown()) ++counts[node->type->name()];
  std::string text;
  for (const auto& [type, count] : counts) {
    const auto kept = graph.kept_types().find(type);
    const std::string plugin = kept == graph.kept_types().end() ? "" : kept->second.plugin;
    text +=
        fmt::format("{}{} of the type '{}' {}", text.empty() ? "" : ", ",
                    count == 1 ? "1 node" : std::to_string(count) + " nodes", type,
                    plugin.empty() ? std::string(count == 1 ? "is of no plug-in that the scene names"
                                                            : "are of no plug-in that the scene names")
                                   : fmt::format("need{} the plug-in '{}'", count == 1 ? "s" : "", plugin));
  }
  return text;
}

}  // namespace plinian::scene
