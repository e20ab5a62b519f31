// connectAttr, disconnectAttr, listConnections.
#include <algorithm>
#include <set>

#include "host/graph/commands/session.h"
#include "host/graph/edits/kept_connections.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

CommandResult connect_attr(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  const Plug destination = graph.plug(arguments.text("destination"));
  session.editor().connect(graph.plug(arguments.text("source")), destination, arguments.has("force"));
  if (const std::string why = without_effect(graph, destination); !why.empty()) session.warn(why);
  return {};
}

// What one attribute and its parts drive of another and its parts.
void disconnect_pair(Session& session, const std::string& source_name, const std::string& name) {
  const Graph& graph = session.graph();
  const Plug source = graph.plug(source_name);
  bool found = false;
  std::string drivers;
  for (const Plug& leaf : leaf_plugs(graph, graph.plug(name))) {
    const auto span = graph.find(leaf.node)->inputs_of(leaf.attribute, leaf.element);
    for (const Input& input : std::vector<Input>(span.begin(), span.end())) {
      if (leaf.component >= 0 && input.component >= 0 && input.component != leaf.component) continue;
      const auto parts = leaf_plugs(graph, source);
      const bool meant = input.source == source || std::ranges::count(parts, input.source);
      if (!meant) {
        drivers += (drivers.empty() ? "" : ", ") + graph.name_of(input.source);
        continue;
      }
      found = true;
      session.editor().history().perform(
          SetInput{{leaf.node, input.attribute, input.element, input.component}, std::nullopt});
    }
  }
  if (!found)
    throw GraphError("disconnectAttr: " + source_name + " does not drive " + name +
                     (drivers.empty() ? ", nor does anything else" : ", which is driven by " + drivers));
}

CommandResult disconnect_attr(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  if (arguments.has("destination")) {
    disconnect_pair(session, arguments.text("plug"), arguments.text("destination"));
    return {};
  }
  const std::size_t before = session.graph().generation();
  session.editor().disconnect(graph.plug(arguments.text("plug")));
  if (graph.generation() == before) throw GraphError(arguments.text("plug") + " is not driven by anything");
  return {};
}

CommandResult list_connections(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  const std::string name = arguments.text("of");
  const bool whole_node = name.find('.') == name.npos;
  const Node& node = graph.get(name.substr(0, name.find('.')));
  std::vector<Plug> plugs;
  if (!whole_node) plugs = leaf_plugs(graph, graph.plug(name));
  const auto wanted = [&](const Plug& plug) {
    if (whole_node) return true;
    for (const Plug& leaf : plugs)
      if (leaf.whole() == plug.whole() && (leaf.component < 0 || plug.component < 0 || leaf == plug))
        return true;
    return false;
  };
  const bool both = arguments.has("source") == arguments.has("destination");
  CommandResult lines;
  if (both || arguments.has("source"))
    for (const Input& input : node.inputs) {
      const Plug destination{node.id, input.attribute, input.element, input.component};
      if (wanted(destination))
        lines.push_back(graph.name_of(input.source) + " -> " + graph.name_of(destination));
    }
  const auto kept = [&](const Node& end, const KeptLine& line) {
    lines.push_back(kept_source_name(graph, line) + " -> " + end.name + "." + line.path);
  };
  if (both || arguments.has("source")) {
    std::set<std::size_t> places;
    for (const Plug& leaf : plugs)
      for (const std::size_t i : kept_connections_into(node, leaf)) places.insert(i);
    for (std::size_t i = 0; i < node.kept.size(); ++i)
      if (node.kept[i].source && (whole_node || places.contains(i))) kept(node, node.kept[i]);
  }
  if (whole_node && (both || arguments.has("destination")))
    for (const Node* end : graph.nodes())
      for (const KeptLine& line : end->kept)
        if (line.source == node.id) kept(*end, line);
  if (both || arguments.has("destination"))
    for (const Connection& connection : graph.outgoing(node.id))
      if (wanted(connection.source))
        lines.push_back(graph.name_of(connection.source) + " -> " + graph.name_of(connection.destination));
  return lines;
}

}  // namespace

void add_connection_commands(CommandRegistry& commands) {
  using enum ArgumentKind;
  commands.add({.name = "connectAttr",
                .help = "Lets one attribute drive another; compounds are connected child by child.",
                .parameters = {{"source", plug, "node.attribute that drives"},
                               {"destination", plug,
                                "node.attribute that is driven; an array takes the next element"}},
                .flags = {{"force", "takes over what is driven by another already", {}}},
                .run = connect_attr});
  commands.add(
      {.name = "disconnectAttr",
       .help = "Breaks the connections into an attribute and its parts.",
       .parameters = {{"plug", plug, "node.attribute that is driven; or, in front of it, what drives it"},
                      {"destination", plug, "then: that is driven by that one", true}},
       .run = disconnect_attr});
  commands.add({.name = "listConnections",
                .help = "Answers with a line for each connection of a node or an attribute.",
                .parameters = {{"of", plug, "node or node.attribute"}},
                .flags = {{"source", "those into it only", {}}, {"destination", "those out of it only", {}}},
                .run = list_connections});
}

}  // namespace plinian::graph
