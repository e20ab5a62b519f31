// ls and select, and how commands find nodes by pattern.
#include <algorithm>
#include <set>

#include "core/scene/nearest_word.h"
#include "host/graph/commands/session.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

// Whether a text matches a pattern in which * stands for any letters and ? for one.
bool matches(std::string_view text, std::string_view pattern) {
  std::size_t t = 0, p = 0, star = pattern.npos, retry = 0;
  while (t < text.size()) {
    if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t]) && pattern[p] != '*') {
      ++t;
      ++p;
    } else if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      retry = t;
    } else if (star != pattern.npos) {
      p = star + 1;
      t = ++retry;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

// What a pattern that matches nothing may have meant: by its letters, or the same in a namespace.
std::string pattern_meant(const std::string& pattern, const std::vector<std::string>& known) {
  for (const std::string& name : known)
    if (const std::size_t colon = name.rfind(':');
        colon != name.npos && matches(name.substr(colon + 1), pattern))
      return " (did you mean '" + name.substr(0, colon + 1) + pattern + "'?)";
  std::string letters = pattern;
  std::erase_if(letters, [](char c) { return c == '*' || c == '?'; });
  return letters.size() < 3 ? "" : did_you_mean(letters, known);  // few letters are like anything
}

CommandResult ls(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  std::vector<NodeId> nodes;
  if (arguments.has("selected"))
    nodes = graph.selection();
  else
    for (const Node* node : graph.nodes()) nodes.push_back(node->id);
  const auto patterns = arguments.texts("patterns");
  if (arguments.has("type")) {
    const std::string type = arguments.text("type");
    const auto of_type = [&](NodeId id) { return graph.find(id)->type->name() == type; };
    if (std::none_of(nodes.begin(), nodes.end(), of_type))
      session.types().get(type);  // is there such a type at all?
    std::erase_if(nodes, [&](NodeId id) { return !of_type(id); });
  }
  if (!patterns.empty())
    std::erase_if(nodes, [&](NodeId id) {
      return std::none_of(patterns.begin(), patterns.end(),
                          [&](const std::string& pattern) { return matches(graph.find(id)->name, pattern); });
    });
  return names_of(graph, nodes);
}

CommandResult select(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  const auto patterns = arguments.texts("nodes");
  if (int(arguments.has("add")) + int(arguments.has("remove")) + int(arguments.has("clear")) > 1)
    throw GraphError("select: -add, -remove and -clear exclude each other");
  if (arguments.has("clear") != patterns.empty())
    throw GraphError(patterns.empty() ? "select: name nodes, or give -clear"
                                      : "select: -clear takes no nodes");
  const std::vector<NodeId> named = matching_nodes(graph, patterns);
  std::vector<NodeId> selection =
      arguments.has("add") || arguments.has("remove") ? graph.selection() : std::vector<NodeId>();
  for (const NodeId id : named) {
    std::erase(selection, id);
    if (!arguments.has("remove")) selection.push_back(id);
  }
  session.editor().select(selection);
  return {};
}

}  // namespace

std::vector<NodeId> matching_nodes(const Graph& graph, const std::vector<std::string>& patterns) {
  std::vector<NodeId> result;
  std::set<NodeId> seen;
  for (const std::string& pattern : patterns) {
    if (pattern.find_first_of("*?") == pattern.npos) {
      const NodeId id = graph.get(pattern).id;
      if (seen.insert(id).second) result.push_back(id);
      continue;
    }
    bool found = false;
    for (const Node* node : graph.nodes()) {
      if (!matches(node->name, pattern)) continue;
      found = true;
      if (seen.insert(node->id).second) result.push_back(node->id);
    }
    if (!found) {
      std::vector<std::string> known;
      for (const Node* node : graph.nodes()) known.push_back(node->name);
      throw GraphError("no node matches " + shown(pattern) + pattern_meant(pattern, known));
    }
  }
  return result;
}

namespace {

bool is_pattern(std::string_view text) {
  return text.find_first_of("*?") != text.npos;
}

// What is in a node at the bottom, of arrays the elements that there are.
std::vector<Plug> leaves_of(const Graph& graph, const Node& node) {
  std::vector<Plug> leaves;
  for (const AttributeIndex top : node.schema->top())
    for (const Plug& leaf : leaf_plugs(graph, {node.id, top}))
      if (!graph.attribute(leaf).spec.hidden) leaves.push_back(leaf);
  return leaves;
}

}  // namespace

std::vector<Plug> matching_plugs(const Graph& graph, const std::vector<std::string>& patterns,
                                 const std::function<bool(const Plug&)>& takes) {
  std::vector<Plug> result;
  std::set<Plug> seen;
  const auto add = [&](const Plug& plug) {
    if (seen.insert(plug).second) result.push_back(plug);
  };
  for (const std::string& pattern : patterns) {
    if (!is_pattern(pattern)) {
      add(graph.plug(pattern));
      continue;
    }
    const std::size_t dot = pattern.find('.');
    if (dot == pattern.npos || dot == 0 || dot + 1 == pattern.size())
      throw GraphError(shown(pattern) + " names no attribute: write NODE.ATTRIBUTE");
    const std::string nodes = pattern.substr(0, dot), path = pattern.substr(dot + 1);
    bool found = false;
    std::set<std::string> known;
    for (const NodeId id : matching_nodes(graph, {nodes})) {
      const Node& node = *graph.find(id);
      for (const std::string& own : node.schema->paths()) known.insert(own);
      std::vector<Plug> plugs;
      if (is_pattern(path)) {
        plugs = leaves_of(graph, node);
        std::erase_if(plugs,
                      [&](const Plug& plug) { return !matches(Graph::path_of(*node.schema, plug), path); });
      } else {
        try {
          plugs = {Graph::plug(node, path)};
        } catch (const GraphError&) {
          continue;  // others may have it
        }
      }
      for (const Plug& plug : plugs) {
        const std::vector<Plug> leaves = leaf_plugs(graph, plug);
        if (leaves.empty() ? !takes(plug) : std::ranges::none_of(leaves, takes)) continue;
        found = true;
        add(plug);
      }
    }
    const bool there = known.contains(path);  // and cannot be used
    if (!found)
      throw GraphError("no attribute matches " + shown(pattern) + " that can be used here" +
                       (there ? "" : pattern_meant(path, {known.begin(), known.end()})));
  }
  return result;
}

std::vector<NodeId> nodes_or_selection(Session& session, const std::vector<std::string>& patterns) {
  if (!patterns.empty()) return matching_nodes(session.graph(), patterns);
  if (session.graph().selection().empty()) throw GraphError("nothing is named and nothing is selected");
  return session.graph().selection();
}

std::vector<std::string> names_of(const Graph& graph, const std::vector<NodeId>& nodes) {
  std::vector<std::string> names;
  for (const NodeId id : nodes) names.push_back(graph.find(id)->name);
  return names;
}

void add_selection_commands(CommandRegistry& commands) {
  using enum ArgumentKind;
  commands.add({.name = "ls",
                .help = "Answers with the names of nodes, in the order of their creation.",
                .parameters = {{"patterns", text, "names with * and ?", true, true}},
                .flags = {{"type", "of this node type only", ArgumentKind::type},
                          {"selected", "selected ones only, in the order of selection", {}}},
                .run = ls});
  commands.add({.name = "select",
                .help = "Selects nodes.",
                .parameters = {{"nodes", node, "names or patterns with * and ?", true, true}},
                .flags = {{"add", "to what is selected already", {}},
                          {"remove", "from what is selected", {}},
                          {"clear", "selects nothing", {}}},
                .run = select});
}

}  // namespace plinian::graph
