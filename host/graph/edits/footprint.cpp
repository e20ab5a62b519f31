// Footprints of edits. Edits say what will be; what was before is looked up.
#include "host/graph/edits/footprint.h"

#include <algorithm>

#include "host/graph/model/graph.h"

namespace plinian::graph {

namespace {

template <class T>
bool meet(const std::set<T>& a, const std::set<T>& b) {
  return std::any_of(a.begin(), a.end(), [&](const T& one) { return b.contains(one); });
}

}  // namespace

void Footprint::add(const Footprint& other) {
  nodes.insert(other.nodes.begin(), other.nodes.end());
  names.insert(other.names.begin(), other.names.end());
  types.insert(other.types.begin(), other.types.end());
  joins = joins || other.joins;
  changes_joints = changes_joints || other.changes_joints;
}

bool Footprint::depends_on(const Footprint& later) const {
  // What both join could go in a circle by way of nodes that neither touches.
  return (joins && later.changes_joints) || meet(nodes, later.nodes) || meet(names, later.names) ||
         meet(types, later.types);
}

FootprintReader::FootprintReader(const Graph& graph) : graph_(graph), selection_(graph.selection()) {}

std::string& FootprintReader::name_of(NodeId id) {
  const Node* node = graph_.find(id);
  return names_.try_emplace(id, node ? node->name : "").first->second;
}

NodeId& FootprintReader::parent_of(NodeId id) {
  const Node* node = graph_.find(id);
  return parents_.try_emplace(id, node ? node->parent : NodeId()).first->second;
}

std::optional<Plug>& FootprintReader::source_of(const Plug& to) {
  const Node* node = graph_.find(to.node);
  const Input* input = node ? node->input(to.attribute, to.element, to.component) : nullptr;
  return sources_.try_emplace(to, input ? std::optional(input->source) : std::nullopt).first->second;
}

Footprint FootprintReader::read(std::span<const Edit> inverses) {
  Footprint footprint;
  for (auto edit = inverses.rbegin(); edit != inverses.rend(); ++edit) add(*edit, footprint);
  footprint.nodes.erase(NodeId());
  footprint.names.erase("");
  return footprint;
}

void FootprintReader::add(const Edit& edit, Footprint& footprint) {
  const auto touch = [&](NodeId node) { footprint.nodes.insert(node); };
  const auto name = [&](NodeId node, const std::string& now) {
    std::string& known = name_of(node);
    footprint.names.insert({known, now});
    known = now;
  };
  if (const auto* add = std::get_if<AddNode>(&edit)) {
    touch(add->node->id);
    touch(parent_of(add->node->id) = add->node->parent);
    name(add->node->id, add->node->name);
  } else if (const auto* remove = std::get_if<RemoveNode>(&edit)) {
    touch(remove->node);
    touch(parent_of(remove->node));
    name(remove->node, "");
  } else if (const auto* replace = std::get_if<ReplaceNode>(&edit)) {
    touch(replace->node->id);
  } else if (const auto* rename = std::get_if<RenameNode>(&edit)) {
    touch(rename->node);
    name(rename->node, rename->name);
  } else if (const auto* value = std::get_if<SetValue>(&edit)) {
    touch(value->plug.node);
  } else if (const auto* input = std::get_if<SetInput>(&edit)) {
    std::optional<Plug>& source = source_of(input->destination);
    touch(input->destination.node);
    if (source) touch(source->node);
    if (input->source) touch(input->source->node);
    source = input->source;
    footprint.joins = footprint.joins || input->source;
    footprint.changes_joints = true;
  } else if (const auto* lock = std::get_if<SetLock>(&edit)) {
    touch(lock->plug.node);
  } else if (const auto* attribute = std::get_if<AddAttribute>(&edit)) {
    touch(attribute->node);
  } else if (const auto* less = std::get_if<RemoveAttribute>(&edit)) {
    touch(less->node);
  } else if (const auto* place = std::get_if<SetParent>(&edit)) {
    touch(place->node);
    touch(parent_of(place->node));
    touch(parent_of(place->node) = place->parent);
    footprint.joins = footprint.joins || place->parent;
    footprint.changes_joints = true;
  } else if (const auto* selected = std::get_if<SetSelection>(&edit)) {
    selection_ = selected->nodes;
  } else {
    footprint.types.insert(std::get<SetKeptType>(edit).type);
  }
}

}  // namespace plinian::graph
