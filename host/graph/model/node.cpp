// Looks things up in a node.
#include "host/graph/model/node.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace plinian::graph {

namespace {

struct PlaceOrder {
  template <class A>
  static auto key(const A& a) {
    return std::tuple(a.attribute, a.element);
  }
  template <class A, class B>
  bool operator()(const A& a, const B& b) const {
    return key(a) < key(b);
  }
};

}  // namespace

const Value* Node::stored(AttributeIndex attribute, std::int32_t element) const {
  const StoredValue place{attribute, element, {}};
  const auto found = std::lower_bound(values.begin(), values.end(), place, PlaceOrder());
  return found != values.end() && found->attribute == attribute && found->element == element ? &found->value
                                                                                             : nullptr;
}

const Value& Node::value(AttributeIndex attribute, std::int32_t element) const {
  const Value* set = stored(attribute, element);
  return set ? *set : (*schema)[attribute].spec.default_value;
}

std::span<const Input> Node::inputs_of(AttributeIndex attribute, std::int32_t element) const {
  const Input place{attribute, element, -1, {}};
  const auto [begin, end] = std::equal_range(inputs.begin(), inputs.end(), place, PlaceOrder());
  return {begin, end};
}

const Input* Node::input(AttributeIndex attribute, std::int32_t element, std::int32_t component) const {
  for (const Input& input : inputs_of(attribute, element))
    if (input.component == component) return &input;
  return nullptr;
}

bool Node::is_locked(AttributeIndex attribute, std::int32_t element) const {
  if (locked.empty()) return false;
  // What holds for a compound or an array holds for all in it.
  for (AttributeIndex at = attribute; at != no_attribute; at = (*schema)[at].parent)
    for (const std::int32_t e : {element, -1})
      if (std::binary_search(locked.begin(), locked.end(), Plug{id, at, e, -1})) return true;
  return false;
}

std::vector<std::int32_t> Node::elements(AttributeIndex attribute) const {
  const AttributeIndex array = (*schema)[attribute].array;
  if (array == no_attribute) return {-1};
  // The attributes of an array stand together in the schema, and so do their values.
  const std::vector<AttributeIndex> leaves = schema->leaves(array);
  std::set<std::int32_t> found;
  const auto collect = [&](const auto& places) {
    const StoredValue first{leaves.front(), -1, {}};
    for (auto at = std::lower_bound(places.begin(), places.end(), first, PlaceOrder());
         at != places.end() && at->attribute <= leaves.back(); ++at)
      found.insert(found.end(), at->element);
  };
  collect(values);
  collect(inputs);
  return {found.begin(), found.end()};
}

}  // namespace plinian::graph
