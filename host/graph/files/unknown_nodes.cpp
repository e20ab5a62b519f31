// Revives and forgets nodes, by way of the lines that a scene file has of them.
#include "host/graph/files/unknown_nodes.h"

#include "host/graph/files/node_reader.h"
#include "host/graph/files/scene_writer.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

std::vector<SceneLine> lines_of(const std::vector<std::string>& texts) {
  std::vector<SceneLine> lines;
  for (const std::string& text : texts) lines.push_back({text, 0});
  return lines;
}

std::vector<NodeId> nodes_of(const Graph& graph, const std::string& type, bool unknown) {
  std::vector<NodeId> result;
  for (const Node* node : graph.nodes())
    if (node->type->name() == type && node->type->is_unknown() == unknown) result.push_back(node->id);
  return result;
}

// Puts nodes where their scene has them, now that types have come or gone. Returns what is to be said of
// those that cannot stand where they did.
std::vector<std::string> settle(Editor& editor) {
  const Graph& graph = editor.graph();
  std::vector<std::string> problems;
  for (const Node* node : graph.nodes()) {
    const bool kept = graph.find(node->kept_parent) != nullptr;
    const NodeId wanted = kept ? node->kept_parent : node->parent;
    if (!wanted) continue;
    const bool can = node->type->spec().hierarchical && graph.find(wanted)->type->spec().holds_children;
    if (can != kept) continue;
    if (std::string problem = editor.place(node->id, wanted); !problem.empty())
      problems.push_back(std::move(problem));
  }
  return problems;
}

}  // namespace

std::vector<std::string> revive_nodes(Editor& editor, const NodeTypePtr& type) {
  Graph& graph = editor.graph();
  const std::vector<NodeId> nodes = nodes_of(graph, type->name(), true);
  std::vector<std::string> warnings;
  if (nodes.empty()) return warnings;
  TypeSection section{type->name(), type->version()};
  KeptType before;
  if (const auto found = graph.kept_types().find(type->name()); found != graph.kept_types().end()) {
    before = found->second;
    section.version = before.version;
    section.plugin = before.plugin;
    section.plugin_version = before.plugin_version;
    section.lines = lines_of(before.lines);
  }
  const NodeTypeSpec& here = type->spec();
  if (before.plugin == here.plugin &&
      version_numbers(before.plugin_version) > version_numbers(here.plugin_version))
    warnings.push_back("nodes of the type '" + here.name + "' were saved with version " +
                       before.plugin_version + " of the plug-in '" + here.plugin + "', here is " +
                       here.plugin_version + ": what is not known here is kept as it is");
  const NodeReader reader(type, section, true);
  const auto node_of = [&](std::string_view name) {
    const Node* node = graph.find(name);
    return node ? node->id : NodeId();
  };
  const WarnLine warn = [&](int, const std::string& message) { warnings.push_back(message); };
  // All of them or none: a scene has one version of a type.
  std::vector<NodeText> read;
  try {
    for (const NodeId id : nodes) {
      const Node& old = *graph.find(id);
      const std::vector<std::string> texts = node_lines(graph, old);
      read.push_back(reader.read(old.name, lines_of(texts), warn,
                                 [&](int, const std::string& message) { warn(0, message); }));
      read.back().node.id = id;
    }
  } catch (const MigrationError& error) {
    return {error.what()};
  }
  editor.set_kept_type(type->name(), reader.keeps_anything() ? std::optional(reader.kept()) : std::nullopt);
  for (NodeText& text : read) {
    const NodeId id = text.node.id, parent = graph.find(id)->parent;
    const bool leaves = parent && !type->spec().hierarchical;
    if (leaves) editor.set_parent({id}, {});
    text.node.parent = leaves ? NodeId() : parent;
    text.node.kept_parent = graph.find(id)->kept_parent;
    editor.replace_node(std::move(text.node));
    if (leaves) warnings.push_back(editor.place(id, parent));
  }
  for (std::string& problem : settle(editor)) warnings.push_back(std::move(problem));
  for (std::size_t i = 0; i < nodes.size(); ++i) finish_node(editor, nodes[i], read[i].links, node_of, warn);
  // Others that were waiting for one of these.
  for (const Node* node : graph.nodes()) {
    if (node->type->is_unknown()) continue;
    NodeLinks waiting;
    std::vector<KeptLine> rest;
    for (const KeptLine& kept : node->kept) {
      const Node* source = kept.source ? graph.find(kept.source) : nullptr;
      if (source && !source->type->is_unknown())
        waiting.connections.push_back({kept.path, source->name + "." + kept.source_path,
                                       "  ." + kept.path + " <- " + source->name + "." + kept.source_path, 0,
                                       kept.place});
      else
        rest.push_back(kept);
    }
    if (waiting.connections.empty()) continue;
    const NodeId id = node->id;
    editor.set_kept(id, std::move(rest));
    // What was locked when it was driven is both again.
    for (const NodeLinks::Link& link : waiting.connections) {
      const std::optional<LinePlace> place = place_in(*graph.find(id), link.path);
      if (!place || !graph.find(id)->is_locked(place->attribute, place->element)) continue;
      const Plug plug{id, place->attribute, place->element, -1};
      editor.lock(plug, false);
      waiting.locks.push_back({Graph::path_of(*graph.find(id)->schema, plug), "", "", 0});
    }
    finish_node(editor, id, waiting, node_of, warn);
  }
  return warnings;
}

void forget_type(Editor& editor, const NodeTypePtr& type) {
  Graph& graph = editor.graph();
  const std::vector<NodeId> nodes = nodes_of(graph, type->name(), false);
  if (nodes.empty()) return;
  KeptType kept{type->version(), type->spec().plugin, type->spec().plugin_version, {}};
  const auto before = graph.kept_types().find(type->name());
  const bool was_kept = before != graph.kept_types().end();
  kept.lines = type_lines(*type, was_kept ? &before->second : nullptr);
  if (was_kept) {
    kept.version = std::max(kept.version, before->second.version);
    if (version_numbers(before->second.plugin_version) > version_numbers(kept.plugin_version))
      kept.plugin_version = before->second.plugin_version;
  }
  // First what the nodes drive becomes lines of those that are driven, ...
  for (const NodeId id : nodes)
    for (const Connection& connection : std::set<Connection>(graph.outgoing(id))) {
      const NodeId driven_id = connection.destination.node;
      const Node& driven = *graph.find(driven_id);
      std::vector<KeptLine> lines = driven.kept;
      const Plug& to = connection.destination;
      lines.push_back({"", Graph::path_of(*driven.schema, to), id,
                       Graph::path_of(*graph.find(id)->schema, connection.source),
                       LinePlace{false, to.attribute, to.element, to.component}});
      editor.history().perform(SetInput{connection.destination, std::nullopt});
      editor.set_kept(driven_id, std::move(lines));
    }
  // ... then they themselves.
  const NodeTypePtr unknown = NodeType::unknown(type->name(), type->version());
  for (const NodeId id : nodes) {
    const Node& node = *graph.find(id);
    Node copy;
    copy.id = node.id;
    copy.name = node.name;
    copy.parent = node.parent;
    copy.kept_parent = node.kept_parent;
    copy.type = unknown;
    copy.schema = unknown->schema();
    const std::vector<std::string> texts = node_lines(graph, node);
    const std::vector<SceneLine> lines = lines_of(texts);
    const NodeReader reader(unknown, TypeSection{type->name()}, true);
    NodeText text = reader.read(
        node.name, lines, [](int, const std::string&) {}, [](int, const std::string&) {});
    copy.kept = std::move(text.node.kept);
    for (const Input& input : std::vector<Input>(node.inputs))
      editor.history().perform(SetInput{{id, input.attribute, input.element, input.component}, std::nullopt});
    editor.replace_node(std::move(copy));
    finish_node(
        editor, id, text.links,
        [&](std::string_view name) {
          const Node* source = graph.find(name);
          return source ? source->id : NodeId();
        },
        [](int, const std::string&) {});
  }
  editor.set_kept_type(type->name(), std::move(kept));
  settle(editor);
}

}  // namespace plinian::graph
