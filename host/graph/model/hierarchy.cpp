// Walks the hierarchy.
#include "host/graph/model/hierarchy.h"

#include <algorithm>

#include "host/graph/model/conversion.h"

namespace plinian::graph {

std::vector<NodeId> ancestors(const Graph& graph, NodeId node) {
  std::vector<NodeId> result;
  for (NodeId at = graph.find(node)->parent; at; at = graph.find(at)->parent) result.push_back(at);
  return result;
}

std::vector<NodeId> with_descendants(const Graph& graph, const std::vector<NodeId>& nodes) {
  const std::set<NodeId> wanted(nodes.begin(), nodes.end());
  std::vector<NodeId> result;
  std::set<NodeId> seen;
  for (const NodeId root : nodes) {
    // What is under another of them is reached from there, after its parent.
    const auto above = ancestors(graph, root);
    if (std::any_of(above.begin(), above.end(), [&](NodeId id) { return wanted.contains(id); })) continue;
    std::vector<NodeId> stack = {root};
    while (!stack.empty()) {
      const NodeId node = stack.back();
      stack.pop_back();
      if (!seen.insert(node).second) continue;
      result.push_back(node);
      const auto& children = graph.children(node);
      stack.insert(stack.end(), children.rbegin(), children.rend());
    }
  }
  return result;
}

AttributeIndex visibility_of(const Schema& schema) {
  const AttributeIndex attribute = schema.find(visibility_attribute);
  if (attribute == no_attribute) return no_attribute;
  const AttributeSpec& spec = schema[attribute].spec;
  return is_number(spec.type) && !spec.array ? attribute : no_attribute;
}

bool is_visible(const Graph& graph, NodeId node) {
  for (NodeId at = node; at; at = graph.find(at)->parent) {
    const Node& found = *graph.find(at);
    const AttributeIndex attribute = visibility_of(*found.schema);
    if (attribute != no_attribute && number_of(found.value(attribute)) == 0.0) return false;
  }
  return true;
}

bool is_shown(const Graph& graph, NodeId node, const std::set<NodeId>& isolated) {
  if (!is_visible(graph, node)) return false;
  if (isolated.empty() || isolated.contains(node)) return true;
  const auto above = ancestors(graph, node);
  if (std::any_of(above.begin(), above.end(), [&](NodeId id) { return isolated.contains(id); })) return true;
  return std::any_of(isolated.begin(), isolated.end(), [&](NodeId id) {
    if (!graph.find(id)) return false;
    const auto chain = ancestors(graph, id);
    return std::find(chain.begin(), chain.end(), node) != chain.end();
  });
}

}  // namespace plinian::graph
