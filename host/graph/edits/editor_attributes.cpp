// Editing values, locks, added attributes and connections.
#include <algorithm>
#include <cmath>

#include "host/graph/edits/connect_problem.h"
#include "host/graph/edits/editor.h"
#include "host/graph/edits/kept_connections.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"

namespace plinian::graph {

std::vector<Plug> leaf_plugs(const Graph& graph, const Plug& plug) {
  const Node& node = *graph.find(plug.node);
  if (plug.component >= 0) return {plug};
  std::vector<Plug> result;
  const auto elements = plug.element >= 0 ? std::vector{plug.element} : node.elements(plug.attribute);
  for (const std::int32_t element : elements)
    for (const AttributeIndex leaf : node.schema->leaves(plug.attribute)) {
      // A compound outside any array may still hold one.
      const bool inner = (*node.schema)[leaf].array != (*node.schema)[plug.attribute].array;
      for (const std::int32_t e : inner ? node.elements(leaf) : std::vector{element})
        result.push_back({plug.node, leaf, e, -1});
    }
  return result;
}

namespace {

// Data are equal where they are the same or are known to hold the same.
bool equal(const Value& a, const Value& b) {
  const auto *x = std::get_if<DataPtr>(&a), *y = std::get_if<DataPtr>(&b);
  return a == b || (x && y && *x && *y && (*x)->content != 0 && (*x)->content == (*y)->content &&
                    (*x)->type == (*y)->type);
}

// With a node of an unknown type at their other end.
void drop_kept_connections(Editor& editor, const Plug& destination) {
  const Node& node = *editor.graph().find(destination.node);
  const std::vector<std::size_t> gone = kept_connections_into(node, destination);
  if (gone.empty()) return;
  std::vector<KeptLine> kept = node.kept;
  for (auto i = gone.rbegin(); i != gone.rend(); ++i) kept.erase(kept.begin() + std::ptrdiff_t(*i));
  editor.set_kept(destination.node, std::move(kept));
}

}  // namespace

std::string Editor::set_problem(const Plug& plug) const {
  const Node& node = *graph_.find(plug.node);
  const SchemaAttribute& attribute = (*node.schema)[plug.attribute];
  const std::string name = graph_.name_of(plug);
  if (attribute.spec.type == AttributeType::compound) return name + " is a compound: set its children";
  if (attribute.array != no_attribute && plug.element < 0)
    return name + " is an array: name an element, as " + attribute.path + "[0]";
  if (attribute.spec.output) return name + " is computed and cannot be set";
  if (attribute.spec.read_only) return name + " is read-only";
  if (node.is_locked(plug.attribute, plug.element)) return name + " is locked";
  const auto is_keyed = [&](const Input& input) {
    return graph_.find(input.source.node)->type->name() == "animCurve";
  };
  for (const Input& input : node.inputs_of(plug.attribute, plug.element))
    if (plug.component < 0 || input.component < 0 || input.component == plug.component)
      return is_keyed(input)
                 ? name + " is keyed (" + graph_.find(input.source.node)->name +
                       "): setKeyframe sets it at a frame, cutKey takes its keys away"
                 : name + " is driven by " + graph_.name_of(input.source) + ": disconnect it first";
  for (const std::size_t i : kept_connections_into(node, plug))
    return name + " is driven by " + kept_source_name(graph_, node.kept[i]) +
           ", of a type that is not known here: disconnect it first";
  return "";
}

bool Editor::set(const Plug& plug, const Value& value) {
  if (const std::string problem = set_problem(plug); !problem.empty()) throw GraphError(problem);
  const Node& node = *graph_.find(plug.node);
  const SchemaAttribute& attribute = (*node.schema)[plug.attribute];
  bool clamped = false;
  Value result;
  try {
    result = plug.component < 0
                 ? value
                 : with_component(node.value(plug.attribute, plug.element), plug.component, number_of(value));
    result = fitted(attribute.spec, result, &clamped);
  } catch (const GraphError& error) {
    throw GraphError(graph_.name_of(plug) + " " + error.what());
  }
  // Elements of arrays exist because they were set; anything else that equals its default is not stored.
  const bool is_default = attribute.array == no_attribute && result == attribute.spec.default_value;
  set_stored(plug.whole(), is_default ? std::nullopt : std::optional(std::move(result)));
  return !clamped;
}

void Editor::set_stored(const Plug& plug, std::optional<Value> value) {
  const Value* stored = graph_.find(plug.node)->stored(plug.attribute, plug.element);
  if (stored ? value && equal(*value, *stored) : !value) return;
  history_.perform(SetValue{plug, std::move(value)});
}

void Editor::reset(const Plug& plug) {
  const History::Scope scope(history_, "reset");
  const SchemaAttribute& attribute = graph_.attribute(plug);
  if (plug.component >= 0) {
    const Value number = component_of(attribute.spec.default_value, plug.component);
    set(plug, number);
    return;
  }
  for (const Plug& leaf : leaf_plugs(graph_, plug)) {
    if (graph_.attribute(leaf).spec.output)
      throw GraphError(graph_.name_of(leaf) + " is computed and cannot be set");
    if (graph_.find(leaf.node)->is_locked(leaf.attribute, leaf.element))
      throw GraphError(graph_.name_of(leaf) + " is locked");
    set_stored(leaf, std::nullopt);
  }
}

void Editor::lock(const Plug& plug, bool locked) {
  const Plug whole = plug.whole();
  const auto& locks = graph_.find(plug.node)->locked;
  if (std::binary_search(locks.begin(), locks.end(), whole) != locked)
    history_.perform(SetLock{whole, locked});
}

Plug Editor::add_attribute(NodeId id, const AttributeSpec& spec) {
  const Node& node = *graph_.find(id);
  if (node.type->is_unknown())
    throw GraphError(node.name + ": its type " + node.type->name() +
                     " is not known here, so nothing can be added");
  try {
    node.schema->with_dynamic(spec);
  } catch (const GraphError& error) {
    throw GraphError(node.name + ": " + error.what());
  }
  history_.perform(AddAttribute{id, std::make_shared<const AttributeSpec>(spec)});
  return {id, graph_.find(id)->schema->find(spec.name)};
}

void Editor::connect(const Plug& source, const Plug& destination, bool replace) {
  const History::Scope scope(history_, "connect");
  const auto type_of = [&](const Plug& plug) { return graph_.attribute(plug).spec.type; };
  if (type_of(source) != AttributeType::compound || type_of(destination) != AttributeType::compound) {
    connect_one(source, destination, replace);
    return;
  }
  const Schema &from = *graph_.find(source.node)->schema, &to = *graph_.find(destination.node)->schema;
  const auto sources = from.leaves(source.attribute), targets = to.leaves(destination.attribute);
  if (sources.size() != targets.size())
    throw GraphError(connect_problem(graph_, source, destination, replace));
  for (std::size_t i = 0; i < sources.size(); ++i)
    connect_one({source.node, sources[i], source.element},
                {destination.node, targets[i], destination.element}, replace);
}

void Editor::connect_one(const Plug& source, Plug destination, bool replace) {
  destination = next_free(graph_, destination);
  const std::string problem = connect_problem(graph_, source, destination, replace);
  if (!problem.empty()) throw GraphError(problem);
  const Node& node = *graph_.find(destination.node);
  const auto inputs = node.inputs_of(destination.attribute, destination.element);
  const Input* same = node.input(destination.attribute, destination.element, destination.component);
  if (same && same->source == source) return;
  const std::vector<Input> before(inputs.begin(), inputs.end());
  for (const Input& input : before)  // a vector is driven as a whole or by its components
    if ((input.component < 0) != (destination.component < 0))
      history_.perform(
          SetInput{{destination.node, input.attribute, input.element, input.component}, std::nullopt});
  history_.perform(SetInput{destination, source});
  drop_kept_connections(*this, destination);
}

void Editor::disconnect(const Plug& destination) {
  const History::Scope scope(history_, "disconnect");
  for (const Plug& leaf : leaf_plugs(graph_, destination)) {
    const auto span = graph_.find(leaf.node)->inputs_of(leaf.attribute, leaf.element);
    const std::vector<Input> inputs(span.begin(), span.end());
    for (const Input& input : inputs)
      if (leaf.component < 0 || input.component < 0 || input.component == leaf.component)
        history_.perform(
            SetInput{{leaf.node, input.attribute, input.element, input.component}, std::nullopt});
  }
  drop_kept_connections(*this, destination);
}

}  // namespace plinian::graph
