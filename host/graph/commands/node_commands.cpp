// createNode, delete, rename, duplicate, parent.
#include "core/scene/nearest_word.h"
#include "host/graph/commands/session.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

// Of some types a scene has one; others of them do nothing, which is worth a line.
void warn_of_second(Session& session, NodeId id) {
  const Node& node = *session.graph().find(id);
  if (!node.type->spec().unique) return;
  for (const Node* other : session.graph().nodes()) {
    if (other->type != node.type) continue;
    if (other->id != id)
      session.warn(node.name + " is another " + node.type->name() +
                   ", of which a scene has one: " + other->name + ", the first, counts");
    return;
  }
}

// The node that -parent names.
NodeId parent_for(Session& session, const NodeType& type, const std::string& name) {
  const auto wrong = [](const std::string& why) { return GraphError("createNode: -parent: " + why); };
  if (!type.spec().hierarchical)
    throw wrong("a " + type.name() + " has no place in the transform hierarchy: leave it out");
  const Node* parent = nullptr;
  try {
    parent = &session.graph().get(name);
  } catch (const GraphError& error) {
    throw wrong(error.what());
  }
  if (!parent->type->spec().holds_children)
    throw wrong(name + " (" + parent->type->name() + ") cannot be a parent: only transforms can");
  return parent->id;
}

CommandResult create_node(Session& session, const Arguments& arguments) {
  const NodeTypePtr type = session.types().get(arguments.text("type"));
  const NodeId parent =
      arguments.has("parent") ? parent_for(session, *type, arguments.text("parent")) : NodeId();
  const NodeId id = session.editor().create_node(type, arguments.text("name"), parent);
  session.editor().select({id});
  warn_of_second(session, id);
  return {session.graph().find(id)->name};
}

CommandResult delete_nodes(Session& session, const Arguments& arguments) {
  std::vector<NodeId> nodes = nodes_or_selection(session, arguments.texts("nodes"));
  if (arguments.has("inputs")) {
    const std::vector<NodeId> more = session.editor().served_only(nodes);
    std::vector<NodeId> told = more;  // curves go with what they drive in any case
    std::erase_if(told, [&](NodeId id) { return session.graph().find(id)->type->spec().follows; });
    if (!told.empty())
      session.note("delete: " + join(names_of(session.graph(), told)) + " too, which served nothing else");
    nodes.insert(nodes.end(), more.begin(), more.end());
  }
  session.editor().delete_nodes(nodes);
  return {};
}

CommandResult rename(Session& session, const Arguments& arguments) {
  return {session.editor().rename(session.graph().get(arguments.text("node")).id, arguments.text("name"))};
}

CommandResult duplicate(Session& session, const Arguments& arguments) {
  const auto copies = session.editor().duplicate(nodes_or_selection(session, arguments.texts("nodes")),
                                                 arguments.has("shareKeys"));
  if (const std::string name = arguments.text("name"); !name.empty())
    for (const NodeId copy : copies) session.editor().rename(copy, name);
  session.editor().select(copies);
  for (const NodeId copy : copies) warn_of_second(session, copy);
  return names_of(session.graph(), copies);
}

CommandResult parent(Session& session, const Arguments& arguments) {
  std::vector<std::string> names = arguments.texts("nodes");
  NodeId above;
  if (!arguments.has("world")) {
    if (names.size() < 2) throw GraphError("parent: name the nodes and, last, their parent, or give -world");
    above = session.graph().get(names.back()).id;
    names.pop_back();
  }
  session.editor().set_parent(matching_nodes(session.graph(), names), above);
  return {};
}

}  // namespace

void add_node_commands(CommandRegistry& commands) {
  using enum ArgumentKind;
  commands.add({.name = "createNode",
                .help = "Makes a node, selects it and answers with its name.",
                .parameters = {{"type", type, "node type"}},
                .flags = {{"name", "what to call it; a number makes it unique", text},
                          {"parent", "node that it goes under", node}},
                .run = create_node});
  commands.add(
      {.name = "delete",
       .help = "Deletes nodes, what is under them, and curves that drove nothing else.",
       .parameters = {{"nodes", node, "names or patterns with * and ?; else the selection", true, true}},
       .flags = {{"inputs", "and what drove nothing but them: of a volume its medium and its file", {}}},
       .run = delete_nodes});
  commands.add(
      {.name = "rename",
       .help = "Renames a node and answers with the name it got.",
       .parameters = {{"node", node, "its name"}, {"name", text, "the new one; a number makes it unique"}},
       .run = rename});
  commands.add(
      {.name = "duplicate",
       .help = "Copies nodes and what is under them: they are driven by what drives the originals, and have "
               "keys of their own.",
       .parameters = {{"nodes", node, "names or patterns; else the selection", true, true}},
       .flags = {{"name", "what the copies are called; numbers make it unique", text},
                 {"shareKeys", "animated by the curves of the originals, not by copies of them", {}}},
       .run = duplicate});
  commands.add({.name = "parent",
                .help = "Puts nodes under another one in the transform hierarchy.",
                .parameters = {{"nodes", node, "the nodes and, last, their parent", false, true}},
                .flags = {{"world", "puts all of them at the top", {}}},
                .run = parent});
}

}  // namespace plinian::graph
