// Counts nodes of unknown types.
#include "host/scene/missing_types.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <vector>

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

const graph::Node* unknown_source(const graph::Graph& graph, graph::NodeId id) {
  std::vector<graph::NodeId> waiting = {id};
  std::set<graph::NodeId> seen = {id};
  while (!waiting.empty()) {
    const graph::Node& node = *graph.find(waiting.back());
    waiting.pop_back();
    std::vector<graph::NodeId> sources;
    for (const graph::Input& input : node.inputs) sources.push_back(input.source.node);
    for (const graph::KeptLine& kept : node.kept) sources.push_back(kept.source);
    for (const graph::NodeId source : sources) {
      const graph::Node* found = graph.find(source);
      if (!found) continue;
      if (found->type->is_unknown()) return found;
      if (seen.insert(source).second) waiting.push_back(source);
    }
  }
  return nullptr;
}

}  // namespace plinian::scene
