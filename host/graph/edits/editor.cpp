// Editing nodes and the hierarchy. editor_attributes.cpp holds values and connections.
#include "host/graph/edits/editor.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "host/graph/graph_error.h"
#include "host/graph/model/hierarchy.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

bool is_node_name(std::string_view name) {
  while (true) {
    const std::size_t colon = name.find(':');
    if (!is_identifier(name.substr(0, colon))) return false;
    if (colon == name.npos) return true;
    name.remove_prefix(colon + 1);
  }
}

namespace {

void check_name(const std::string& name) {
  if (!is_node_name(name))
    throw GraphError(shown(name) +
                     " cannot name a node: a letter or _, then letters, digits and _, with ':' after "
                     "a namespace");
}

void check_parent(const Graph& graph, const NodeType& type, const std::string& name, NodeId parent) {
  if (!parent) return;
  if (!type.spec().hierarchical)
    throw GraphError(name + " (" + type.name() + ") has no place in the transform hierarchy");
  const Node& above = *graph.find(parent);
  if (!above.type->spec().holds_children)
    throw GraphError(above.name + " (" + above.type->name() + ") cannot be a parent: only transforms can");
}

}  // namespace

NodeId Editor::create_node(const NodeTypePtr& type, const std::string& name, NodeId parent) {
  Node node;
  node.type = type;
  node.schema = type->schema();
  node.name = name.empty() ? type->name() + "1" : name;
  node.parent = parent;
  return add_node(std::move(node));
}

// A scene has one version of a type: beside nodes that could not be migrated to this one there can be none.
void Editor::check_version(const NodeType& type) {
  const auto kept = graph_.kept_types().find(type.name());
  if (type.is_unknown() || kept == graph_.kept_types().end() || kept->second.version >= type.version())
    return;
  for (const Node* other : graph_.nodes())
    if (other->type->is_unknown() && other->type->name() == type.name())
      throw GraphError("there can be no new " + type.name() + " beside " + other->name +
                       ", which is of version " + std::to_string(kept->second.version) +
                       " of the type: load a plug-in that can migrate it, or delete it first");
  set_kept_type(type.name(), std::nullopt);  // they are gone
}

NodeId Editor::add_node(Node node) {
  const History::Scope scope(history_, "add");
  check_version(*node.type);
  check_name(node.name);
  check_parent(graph_, *node.type, node.name, node.parent);
  node.id = graph_.new_id();
  node.name = graph_.unique_name(node.name);
  for (Plug& plug : node.locked) plug.node = node.id;
  const NodeId id = node.id;
  history_.perform(AddNode{std::make_shared<const Node>(std::move(node))});
  return id;
}

void Editor::disconnect_all(NodeId id) {
  const auto outgoing = graph_.outgoing(id);  // copies: the graph changes meanwhile
  for (const Connection& connection : outgoing)
    history_.perform(SetInput{connection.destination, std::nullopt});
  const auto inputs = graph_.find(id)->inputs;
  for (auto input = inputs.rbegin(); input != inputs.rend(); ++input)
    history_.perform(SetInput{{id, input->attribute, input->element, input->component}, std::nullopt});
}

// Nodes that would be left driving nothing once `doomed` are gone, of those that go then.
std::vector<NodeId> Editor::followers(const std::vector<NodeId>& doomed,
                                      const std::function<bool(const Node&)>& goes) const {
  std::set<NodeId> gone(doomed.begin(), doomed.end());
  std::vector<NodeId> result, queue = doomed;
  while (!queue.empty()) {
    const NodeId id = queue.back();
    queue.pop_back();
    for (const Input& input : graph_.find(id)->inputs) {
      const NodeId driver = input.source.node;
      if (gone.contains(driver) || !goes(*graph_.find(driver))) continue;
      const auto& outgoing = graph_.outgoing(driver);
      if (!std::all_of(outgoing.begin(), outgoing.end(),
                       [&](const Connection& c) { return gone.contains(c.destination.node); }))
        continue;
      gone.insert(driver);
      result.push_back(driver);
      queue.push_back(driver);
    }
  }
  return result;
}

std::vector<NodeId> Editor::served_only(const std::vector<NodeId>& nodes) const {
  std::set<NodeId> drives_unknown;
  for (const Node* node : graph_.nodes())
    for (const KeptLine& line : node->kept) drives_unknown.insert(line.source);
  return followers(with_descendants(graph_, nodes), [&](const Node& node) {
    const NodeTypeSpec& spec = node.type->spec();
    return !spec.hierarchical && !spec.unique && !node.type->is_unknown() &&
           !drives_unknown.contains(node.id);
  });
}

void Editor::delete_nodes(const std::vector<NodeId>& nodes) {
  const History::Scope scope(history_, "delete");
  std::vector<NodeId> doomed = with_descendants(graph_, nodes);
  // Those that only exist to drive, as curves do.
  const auto more = followers(doomed, [](const Node& node) { return node.type->spec().follows; });
  doomed.insert(doomed.end(), more.begin(), more.end());
  const std::set<NodeId> gone(doomed.begin(), doomed.end());
  std::vector<NodeId> selected = graph_.selection();
  if (std::erase_if(selected, [&](NodeId id) { return gone.contains(id); })) select(selected);
  for (auto id = doomed.rbegin(); id != doomed.rend(); ++id) {  // children before parents
    disconnect_all(*id);
    history_.perform(RemoveNode{*id});
  }
}

std::string Editor::rename(NodeId id, const std::string& name) {
  check_name(name);
  if (graph_.find(id)->name == name) return name;
  const std::string unique = graph_.unique_name(name);
  history_.perform(RenameNode{id, unique});
  return unique;
}

std::vector<NodeId> Editor::duplicate(const std::vector<NodeId>& nodes, bool share_keys) {
  const History::Scope scope(history_, "duplicate");
  std::unordered_map<NodeId, NodeId> copies;
  std::vector<NodeId> originals = with_descendants(graph_, nodes);
  // What only exists to drive a node, as the curves of its keys, is copied with it.
  if (!share_keys) {
    std::set<NodeId> among(originals.begin(), originals.end());
    for (std::size_t i = 0; i < originals.size(); ++i)
      for (const Input& input : graph_.find(originals[i])->inputs)
        if (graph_.find(input.source.node)->type->spec().follows && among.insert(input.source.node).second)
          originals.push_back(input.source.node);
  }
  for (const NodeId id : originals) {
    Node copy = *graph_.find(id);
    copy.inputs.clear();
    for (NodeId* above : {&copy.parent, &copy.kept_parent})
      if (const auto parent = copies.find(*above); parent != copies.end()) *above = parent->second;
    copies.emplace(id, add_node(std::move(copy)));
  }
  for (const NodeId id : originals) {
    // Connections that are kept for a node of an unknown type are copied as others are.
    std::vector<KeptLine> kept = graph_.find(id)->kept;
    for (KeptLine& line : kept)
      if (const auto copy = copies.find(line.source); copy != copies.end()) line.source = copy->second;
    if (!graph_.find(id)->kept.empty()) set_kept(copies.at(id), std::move(kept));
    const auto inputs = graph_.find(id)->inputs;
    for (const Input& input : inputs) {
      Plug source = input.source;
      if (const auto copy = copies.find(source.node); copy != copies.end()) source.node = copy->second;
      history_.perform(SetInput{{copies.at(id), input.attribute, input.element, input.component}, source});
    }
  }
  std::vector<NodeId> result;
  for (const NodeId id : nodes) result.push_back(copies.at(id));
  return result;
}

void Editor::set_parent(const std::vector<NodeId>& nodes, NodeId parent) {
  const History::Scope scope(history_, "parent");
  for (const NodeId id : nodes) {
    if (graph_.find(id)->kept_parent && (!parent || graph_.find(id)->type->spec().hierarchical)) {
      keep_parent(id, {});
      if (!graph_.find(id)->type->spec().hierarchical) continue;
    }
    const Node& node = *graph_.find(id);
    if (!node.type->spec().hierarchical)
      throw GraphError(node.name + " (" + node.type->name() + ") has no place in the transform hierarchy");
    check_parent(graph_, *node.type, node.name, parent);
    if (node.parent == parent) continue;
    if (parent == id || (parent && !graph_.children(id).empty())) {
      auto chain = ancestors(graph_, parent);
      chain.insert(chain.begin(), parent);
      if (const auto above = std::find(chain.begin(), chain.end(), id); above != chain.end()) {
        std::string way = node.name;
        for (auto at = std::make_reverse_iterator(above); at != chain.rend(); ++at)
          way += " -> " + graph_.find(*at)->name;
        throw GraphError(node.name + " cannot be under itself: " + way);
      }
    }
    history_.perform(SetParent{id, parent});
  }
}

void Editor::keep_parent(NodeId id, NodeId parent) {
  if (graph_.find(id)->kept_parent == parent) return;
  Node node = *graph_.find(id);
  node.kept_parent = parent;
  history_.perform(ReplaceNode{std::make_shared<const Node>(std::move(node))});
}

std::string Editor::place(NodeId id, NodeId parent) {
  const History::Scope scope(history_, "parent");
  const auto problem = [&](const Node& wrong, const char* why) {
    return wrong.name + " (" + wrong.type->name() + ") " + why + ": that " + graph_.find(id)->name +
           " stands under " + graph_.find(parent)->name + " is kept in the scene and moves nothing";
  };
  if (!graph_.find(id)->type->spec().hierarchical) {
    keep_parent(id, parent);
    return problem(*graph_.find(id), "has no place in the transform hierarchy");
  }
  NodeId nearest = parent;
  while (nearest && !graph_.find(nearest)->type->spec().holds_children)
    nearest = graph_.find(nearest)->parent;
  set_parent({id}, nearest);
  if (nearest == parent) return "";
  keep_parent(id, parent);
  return problem(*graph_.find(parent), "cannot be a parent");
}

void Editor::set_kept(NodeId id, std::vector<KeptLine> kept) {
  Node node = *graph_.find(id);
  node.kept = std::move(kept);
  history_.perform(ReplaceNode{std::make_shared<const Node>(std::move(node))});
}

void Editor::set_kept_type(const std::string& type, std::optional<KeptType> kept) {
  const auto before = graph_.kept_types().find(type);
  const bool there = before != graph_.kept_types().end();
  if (there ? kept && *kept == before->second : !kept) return;
  history_.perform(SetKeptType{type, std::move(kept)});
}

void Editor::replace_node(Node node) {
  history_.perform(ReplaceNode{std::make_shared<const Node>(std::move(node))});
}

void Editor::select(const std::vector<NodeId>& nodes) {
  if (graph_.selection() != nodes) history_.perform(SetSelection{nodes});
}

}  // namespace plinian::graph
