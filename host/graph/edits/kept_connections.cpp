#include "host/graph/edits/kept_connections.h"

#include <string_view>

namespace plinian::graph {

namespace {

bool holds(std::string_view whole, std::string_view part) {
  return part.starts_with(whole) &&
         (part.size() == whole.size() || part[whole.size()] == '.' || part[whole.size()] == '[');
}

}  // namespace

std::vector<std::size_t> kept_connections_into(const Node& node, const Plug& plug) {
  std::vector<std::size_t> found;
  if (node.kept.empty()) return found;
  const std::string path = Graph::path_of(*node.schema, plug);
  for (std::size_t i = 0; i < node.kept.size(); ++i) {
    const KeptLine& line = node.kept[i];
    if (line.source && (holds(line.path, path) || holds(path, line.path))) found.push_back(i);
  }
  return found;
}

std::string kept_source_name(const Graph& graph, const KeptLine& line) {
  return graph.find(line.source)->name + "." + line.source_path;
}

}  // namespace plinian::graph
