// Looks things up in the graph: names, plugs, snapshots. graph_edits.cpp holds what changes it.
#include "host/graph/model/graph.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

namespace {

constexpr std::int32_t largest_element = 1'000'000'000;
constexpr std::string_view axis_letters = "xyzw", colour_letters = "rgba";

std::string_view component_letters(AttributeType type) {
  return type == AttributeType::colour ? colour_letters : axis_letters;
}

// " (did you mean 'translate.x'?)": what Maya calls translateX, or tx, is a part of a compound here.
std::string meant_path(const Schema& schema, const std::string& path) {
  const char part = path.empty() ? ' ' : char(std::tolower(static_cast<unsigned char>(path.back())));
  for (const AttributeIndex top : schema.top()) {
    const std::string& name = schema[top].path;
    const std::string whole = name + "." + part;
    const std::string before = path.substr(0, path.empty() ? 0 : path.size() - 1);
    if ((before == name || (before.size() == 1 && name.starts_with(before))) &&
        schema.find(whole) != no_attribute)
      return " (did you mean '" + whole + "'?)";
  }
  return did_you_mean(path, schema.paths());
}

}  // namespace

Graph::Graph() : outgoing_(1), children_(1) {}

const Node* Graph::find(std::string_view name) const {
  const NodeId* found = by_name_.find(name);
  return found ? find(*found) : nullptr;
}

const Node& Graph::get(std::string_view name) const {
  if (const Node* node = find(name)) return *node;
  std::vector<std::string> known;
  for (const Node* node : nodes()) known.push_back(node->name);
  std::string hint = hint_at_node ? hint_at_node(name) : "";
  if (hint.empty()) hint = did_you_mean(name, known);
  // What was imported into a namespace is called so by whoever forgot it.
  const std::string inside = ":" + std::string(name);
  for (std::size_t i = 0; hint.empty() && i < known.size(); ++i)
    if (known[i].ends_with(inside)) hint = " (did you mean '" + known[i] + "'?)";
  throw GraphError("there is no node " + shown(name) + hint);
}

std::vector<const Node*> Graph::nodes() const {
  std::vector<const Node*> result;
  result.reserve(size());
  for (NodeId id; id.value < nodes_.end(); ++id.value)
    if (const Node* node = nodes_.find(id)) result.push_back(node);
  return result;
}

std::string Graph::path_of(const Schema& schema, const Plug& plug) {
  const SchemaAttribute& attribute = schema[plug.attribute];
  std::string path = attribute.path;
  if (plug.element >= 0) {
    std::string subscript = std::to_string(plug.element);
    subscript.insert(subscript.begin(), '[');
    path.insert(schema[attribute.array].path.size(), subscript + ']');
  }
  if (plug.component >= 0) {
    path += '.';
    path += component_letters(attribute.spec.type)[std::size_t(plug.component)];
  }
  return path;
}

std::string Graph::name_of(const Plug& plug) const {
  const Node* node = find(plug.node);
  return node ? node->name + "." + path_of(*node->schema, plug) : "";
}

Plug Graph::plug(std::string_view name) const {
  const std::size_t dot = name.find('.');
  if (dot == name.npos || dot == 0)
    throw GraphError(shown(name) + " names no attribute: write NODE.ATTRIBUTE");
  const Node& node = get(name.substr(0, dot));
  if (node.type->is_unknown()) {
    const auto kept = kept_types_.find(node.type->name());
    const std::string plugin = kept == kept_types_.end() ? "" : kept->second.plugin;
    if (is_registered && is_registered(node.type->name()))
      throw GraphError("node '" + node.name + "' (" + node.type->name() + ") has no attribute " +
                       shown(std::string(name.substr(dot + 1))) + ": it is kept as it was saved, since " +
                       (plugin.empty() ? "what is here" : "the plug-in '" + plugin + "' that is loaded") +
                       " could not migrate it");
    throw GraphError(
        "node '" + node.name + "' (" + node.type->name() + ") has no attribute " +
        shown(std::string(name.substr(dot + 1))) + ": its type is not known here" +
        (plugin.empty() ? "" : "; the plug-in '" + plugin + "' brings it: loadPlugin " + plugin));
  }
  try {
    return plug(node, name.substr(dot + 1));
  } catch (const GraphError& error) {
    const std::string said = error.what();
    if (!said.ends_with('\'')) throw;  // it says more than that there is none
    throw GraphError(said + "; getAttr " + node.name + " lists those it has");
  }
}

Plug Graph::plug(const Node& node, std::string_view path) {
  const Schema& schema = *node.schema;
  std::string plain = node.type->current_path(path);
  const auto fail = [&](const std::string& why) -> Plug {
    throw GraphError(node.name + ": " + shown(path) + " " + why);
  };
  Plug plug{node.id};
  const std::size_t open = plain.find('['), close = plain.find(']');
  std::size_t array_length = 0;
  if (open != plain.npos) {
    const char* first = plain.data() + open + 1;
    const char* last = close == plain.npos ? first : plain.data() + close;
    const auto [end, error] = std::from_chars(first, last, plug.element);
    const bool large = error == std::errc::result_out_of_range || plug.element > largest_element;
    if (end == last && first != last && large)
      return fail("has too large a number: the last element there can be is [" +
                  std::to_string(largest_element) + "]");
    if (error != std::errc() || end != last || plug.element < 0)
      return fail("is no attribute: an element is written [0], [1], ...");
    array_length = open;
    plain.erase(open, close - open + 1);
  }
  plug.attribute = schema.find(plain);
  // The last letter may be a component.
  if (plug.attribute == no_attribute && plain.size() > 2 && plain[plain.size() - 2] == '.') {
    const AttributeIndex vector = schema.find(plain.substr(0, plain.size() - 2));
    if (vector != no_attribute) {
      const AttributeType type = schema[vector].spec.type;
      const std::size_t component = component_letters(type).find(plain.back());
      if (component < std::size_t(component_count(type))) {
        plug.attribute = vector;
        plug.component = int(component);
      }
    }
  }
  if (plug.attribute == no_attribute) {
    const std::string kind =
        node.type->is_unknown() ? ", whose type " + node.type->name() + " is not known here" : "";
    throw GraphError("node '" + node.name + "' (" + node.type->name() + ") has no attribute " + shown(plain) +
                     meant_path(schema, plain) + kind);
  }
  const AttributeIndex array = schema[plug.attribute].array;
  if (plug.element >= 0 && (array == no_attribute || schema[array].path.size() != array_length))
    return fail("is no array there");
  return plug;
}

NodeNames Graph::names() const {
  return {[this](NodeId id) {
            const Node* node = find(id);
            return node ? node->name : std::string();
          },
          [this](std::string_view name) {
            const Node* node = find(name);
            return node ? node->id : NodeId();
          }};
}

std::string Graph::unique_name(const std::string& wanted) const {
  if (!by_name_.contains(wanted)) return wanted;
  std::string base = wanted;
  while (!base.empty() && base.back() >= '0' && base.back() <= '9') base.pop_back();
  int& number = next_number_.try_emplace(base, 1).first->second;
  while (by_name_.contains(base + std::to_string(number))) ++number;
  return base + std::to_string(number);
}

GraphSnapshotPtr Graph::snapshot() const {
  if (!snapshot_ || snapshot_->generation_ != generation_) {
    const auto snapshot = std::make_shared<GraphSnapshot>();
    snapshot->nodes_ = nodes_;
    snapshot->generation_ = generation_;
    snapshot_ = snapshot;
    ++epoch_;
  }
  return snapshot_;
}

}  // namespace plinian::graph
