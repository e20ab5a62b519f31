// The only code that changes a graph. It checks nothing: Editor does.
#include <algorithm>
#include <cassert>
#include <utility>

#include "host/graph/model/graph.h"

namespace plinian::graph {

namespace {

// Where an entry of a sorted vector is or belongs.
template <class Entry, class Key>
auto place(std::vector<Entry>& entries, const Key& key) {
  return std::lower_bound(entries.begin(), entries.end(), key, [](const Entry& entry, const Key& wanted) {
    if constexpr (std::is_same_v<Entry, Plug>)
      return entry < wanted;
    else if constexpr (std::is_same_v<Entry, Input>)
      return Plug{wanted.node, entry.attribute, entry.element, entry.component} < wanted;
    else
      return Plug{wanted.node, entry.attribute, entry.element, -1} < wanted;
  });
}

// A name without the number at its end, and that number.
std::pair<std::string, int> split_number(const std::string& name) {
  std::size_t end = name.size();
  while (end > 0 && name[end - 1] >= '0' && name[end - 1] <= '9') --end;
  const std::string digits = name.substr(end);
  return {name.substr(0, end), digits.empty() || digits.size() > 9 ? 0 : std::stoi(digits)};
}

}  // namespace

Edit Graph::apply(const Edit& edit) {
  Edit inverse = std::visit([this](const auto& one) { return apply_one(one); }, edit);
  ++generation_;
  for (GraphObserver* observer : observers_) observer->edited(edit);
  return inverse;
}

// The node itself, or a copy in its place where a snapshot may hold it.
Node& Graph::changeable(NodeId id) {
  std::shared_ptr<Node>& node = nodes_.place(id, epoch_);
  assert(node);
  if (node->epoch < epoch_) {
    node = std::make_shared<Node>(*node);
    node->epoch = epoch_;
  }
  return *node;
}

Edit Graph::apply_one(const AddNode& edit) {
  const auto node = std::make_shared<Node>(*edit.node);
  node->epoch = epoch_;
  next_id_ = std::max(next_id_, node->id.value + 1);
  if (outgoing_.size() <= node->id.value) {
    outgoing_.resize(node->id.value + 1);
    children_.resize(node->id.value + 1);
  }
  assert(!nodes_.find(node->id) && !by_name_.contains(node->name) && node->inputs.empty());
  nodes_.place(node->id, epoch_) = node;
  by_name_[node->name] = node->id;
  if (node->type->spec().hierarchical) children_[node->parent.value].insert(node->id);
  return RemoveNode{node->id};
}

Edit Graph::apply_one(const RemoveNode& edit) {
  const std::shared_ptr<Node> node = std::exchange(nodes_.place(edit.node, epoch_), nullptr);
  assert(node && node->inputs.empty() && outgoing_[edit.node.value].empty() &&
         children_[edit.node.value].empty());
  by_name_.erase(node->name);
  children_[node->parent.value].erase(node->id);
  const auto [base, number] = split_number(node->name);
  const auto taken = next_number_.find(base);
  if (taken != next_number_.end() && number > 0) taken->second = std::min(taken->second, number);
  return AddNode{node};
}

Edit Graph::apply_one(const ReplaceNode& edit) {
  std::shared_ptr<Node>& node = nodes_.place(edit.node->id, epoch_);
  assert(node && node->name == edit.node->name && node->parent == edit.node->parent);
  ReplaceNode inverse{std::move(node)};
  if (edit.node->type->spec().hierarchical)
    children_[edit.node->parent.value].insert(edit.node->id);
  else
    children_[edit.node->parent.value].erase(edit.node->id);
  node = std::make_shared<Node>(*edit.node);
  node->epoch = epoch_;
  return inverse;
}

Edit Graph::apply_one(const RenameNode& edit) {
  Node& node = changeable(edit.node);
  RenameNode inverse{edit.node, node.name};
  const auto [base, number] = split_number(node.name);
  const auto taken = next_number_.find(base);
  if (taken != next_number_.end() && number > 0) taken->second = std::min(taken->second, number);
  by_name_.erase(node.name);
  by_name_[edit.name] = edit.node;
  node.name = edit.name;
  return inverse;
}

Edit Graph::apply_one(const SetValue& edit) {
  Node& node = changeable(edit.plug.node);
  const auto at = place(node.values, edit.plug);
  const bool there =
      at != node.values.end() && at->attribute == edit.plug.attribute && at->element == edit.plug.element;
  SetValue inverse{edit.plug, std::nullopt};
  if (there) inverse.value = std::move(at->value);
  if (edit.value && there)
    at->value = *edit.value;
  else if (edit.value)
    node.values.insert(at, {edit.plug.attribute, edit.plug.element, *edit.value});
  else if (there)
    node.values.erase(at);
  return inverse;
}

Edit Graph::apply_one(const SetInput& edit) {
  const Plug& to = edit.destination;
  Node& node = changeable(to.node);
  const auto at = place(node.inputs, to);
  const bool there = at != node.inputs.end() && at->attribute == to.attribute && at->element == to.element &&
                     at->component == to.component;
  SetInput inverse{to, std::nullopt};
  if (there) {
    inverse.source = at->source;
    outgoing_[at->source.node.value].erase({at->source, to});
  }
  if (edit.source) outgoing_[edit.source->node.value].insert({*edit.source, to});
  if (edit.source && there)
    at->source = *edit.source;
  else if (edit.source)
    node.inputs.insert(at, {to.attribute, to.element, to.component, *edit.source});
  else if (there)
    node.inputs.erase(at);
  return inverse;
}

Edit Graph::apply_one(const SetLock& edit) {
  Node& node = changeable(edit.plug.node);
  const auto at = place(node.locked, edit.plug);
  const bool there = at != node.locked.end() && *at == edit.plug;
  if (edit.locked && !there)
    node.locked.insert(at, edit.plug);
  else if (!edit.locked && there)
    node.locked.erase(at);
  return SetLock{edit.plug, there};
}

Edit Graph::apply_one(const AddAttribute& edit) {
  Node& node = changeable(edit.node);
  node.schema = std::make_shared<const Schema>(node.schema->with_dynamic(*edit.spec));
  return RemoveAttribute{edit.node};
}

Edit Graph::apply_one(const RemoveAttribute& edit) {
  Node& node = changeable(edit.node);
  const AttributeIndex last = node.schema->top().back();
  AddAttribute inverse{edit.node, std::make_shared<const AttributeSpec>(node.schema->declaration(last))};
  node.schema = std::make_shared<const Schema>(node.schema->without_last_dynamic());
  return inverse;
}

Edit Graph::apply_one(const SetParent& edit) {
  Node& node = changeable(edit.node);
  SetParent inverse{edit.node, node.parent};
  children_[node.parent.value].erase(edit.node);
  children_[edit.parent.value].insert(edit.node);
  node.parent = edit.parent;
  return inverse;
}

Edit Graph::apply_one(const SetSelection& edit) {
  SetSelection inverse{std::move(selection_)};
  selection_ = edit.nodes;
  return inverse;
}

Edit Graph::apply_one(const SetKeptType& edit) {
  SetKeptType inverse{edit.type, std::nullopt};
  const auto at = kept_types_.find(edit.type);
  if (at != kept_types_.end()) {
    inverse.kept = std::move(at->second);
    kept_types_.erase(at);
  }
  if (edit.kept) kept_types_.emplace(edit.type, *edit.kept);
  return inverse;
}

}  // namespace plinian::graph
