// setAttr, getAttr, resetAttr, addAttr, lockAttr.
#include <span>

#include "host/graph/commands/session.h"
#include "host/graph/edits/kept_connections.h"
#include "host/graph/files/attribute_declaration.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"

namespace plinian::graph {

namespace {

// Of a component, one number.
AttributeSpec spec_of(const Graph& graph, const Plug& plug) {
  AttributeSpec spec = graph.attribute(plug).spec;
  if (plug.component < 0) return spec;
  spec.type = AttributeType::float1;
  return spec;
}

// As it is stored, not as it is driven.
std::string words_now(const Graph& graph, const Plug& plug) {
  const Value& value = graph.find(plug.node)->value(plug.attribute, plug.element);
  return plug.component < 0
             ? write_value(graph.attribute(plug).spec, value, graph.names())
             : write_value(spec_of(graph, plug), component_of(value, plug.component), graph.names());
}

// Returns whether the value holds as it was given.
bool set_one(Session& session, const Plug& plug, std::span<const Word> words) {
  const Graph& graph = session.graph();
  const std::string name = graph.name_of(plug);
  if (const std::string problem = session.editor().set_problem(plug); !problem.empty())
    throw GraphError(problem);
  Value value;
  try {
    value = read_value(spec_of(graph, plug), words, graph.names());
  } catch (const GraphError& error) {
    throw GraphError(name + " " + error.what());
  }
  if (session.editor().set(plug, value)) return true;
  session.warn(name + " is out of its range (" + expectation(graph.attribute(plug).spec) +
               ") and was set to " + words_now(graph, plug.whole()));
  return false;
}

// What a pattern may mean.
bool is_input(const Graph& graph, const Plug& plug) {
  const AttributeSpec& spec = graph.attribute(plug).spec;
  return !spec.output && !spec.read_only;
}

std::vector<Plug> matching_inputs(const Graph& graph, const std::vector<std::string>& patterns) {
  return matching_plugs(graph, patterns, [&](const Plug& plug) { return is_input(graph, plug); });
}

// Returns the plug with the values that it has now, where they are not all as they were given.
std::string set_plug(Session& session, const Plug& plug, const std::vector<Word>& words) {
  const Graph& graph = session.graph();
  const bool compound = graph.attribute(plug).spec.type == AttributeType::compound;
  // A compound of single values is set as a vector is.
  const std::vector<Plug> leaves = compound ? leaf_plugs(graph, plug) : std::vector{plug};
  if (compound && words.size() != leaves.size())
    throw GraphError(graph.name_of(plug) + " expects " + std::to_string(leaves.size()) +
                     " values, one for each of its parts");
  bool holds = true;
  for (std::size_t i = 0; i < leaves.size(); ++i)
    holds &= set_one(session, leaves[i], compound ? std::span(words).subspan(i, 1) : std::span(words));
  if (holds) return "";
  std::string now = graph.name_of(plug);
  for (const Plug& leaf : leaves) now += " " + words_now(graph, leaf);
  return now;
}

CommandResult set_attr(Session& session, const Arguments& arguments) {
  const std::vector<Plug> plugs = matching_inputs(session.graph(), {arguments.text("plug")});
  for (const Plug& plug : plugs) {
    const std::string now = set_plug(session, plug, arguments.words("value"));
    // What several were set to has no line of its own.
    if (!now.empty() && plugs.size() == 1) session.echo_as("setAttr " + now);
  }
  return {};
}

// What can be set on a node and written down.
std::vector<Plug> inputs_with_text(const Graph& graph, const Node& node) {
  std::vector<Plug> plugs;
  const Schema& schema = *node.schema;
  for (AttributeIndex i = 0; i < AttributeIndex(schema.size()); ++i) {
    const AttributeSpec& spec = schema[i].spec;
    if (spec.output || spec.hidden || spec.type == AttributeType::data ||
        spec.type == AttributeType::compound)
      continue;
    for (const Plug& leaf : leaf_plugs(graph, {node.id, i})) plugs.push_back(leaf);
  }
  return plugs;
}

// A value as it is now, or at another time.
std::string read_plug(Session& session, const Plug& plug, std::optional<double> time) {
  const Graph& graph = session.graph();
  const Node& node = *graph.find(plug.node);
  for (const std::size_t i : kept_connections_into(node, plug))
    throw GraphError(graph.name_of(plug) + " is driven by " + kept_source_name(graph, node.kept[i]) +
                     ", of a type that is not known here: its value is not known either");
  const ResultPtr result =
      time ? session.evaluator().evaluate_at(*time, plug) : session.evaluator().evaluate(plug);
  if (result->error)
    throw GraphError(graph.name_of(plug) + ": " + session.evaluator().error_text(plug, *result));
  return write_value(spec_of(graph, plug), result->value, graph.names());
}

// A line for each of several, with its whole name.
CommandResult get_matching(Session& session, const Arguments& arguments, const std::string& pattern) {
  const Graph& graph = session.graph();
  const auto has_text = [&](const Plug& plug) {
    return graph.attribute(plug).spec.type != AttributeType::data;
  };
  CommandResult lines;
  for (const Plug& plug : matching_plugs(graph, {pattern}, has_text))
    for (const Plug& leaf : leaf_plugs(graph, plug)) {
      const Node& node = *graph.find(leaf.node);
      const bool locked = arguments.has("lock") && node.is_locked(leaf.attribute, leaf.element);
      lines.push_back(graph.name_of(leaf) + " " +
                      (arguments.has("lock") ? (locked ? "true" : "false")
                                             : read_plug(session, leaf, arguments.number("time"))));
    }
  return lines;
}

CommandResult get_attr(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  const std::string name = arguments.text("plug");
  if (name.find_first_of("*?") != name.npos) return get_matching(session, arguments, name);
  const Node* node = name.find('.') == name.npos && !arguments.has("lock") ? &graph.get(name) : nullptr;
  const Plug plug = node ? Plug() : graph.plug(name);
  if (arguments.has("lock"))
    return {graph.find(plug.node)->is_locked(plug.attribute, plug.element) ? "true" : "false"};
  const auto time = arguments.number("time");
  const auto read = [&](const Plug& leaf) { return read_plug(session, leaf, time); };
  const std::vector<Plug> leaves = node ? inputs_with_text(graph, *node) : leaf_plugs(graph, plug);
  if (!node && leaves.size() == 1 && leaves[0] == plug) return {read(plug)};
  CommandResult lines;
  for (const Plug& leaf : leaves)
    lines.push_back(Graph::path_of(*graph.find(leaf.node)->schema, leaf) + " " + read(leaf));
  return lines;
}

CommandResult reset_attr(Session& session, const Arguments& arguments) {
  for (const Plug& plug : matching_inputs(session.graph(), arguments.texts("plugs")))
    session.editor().reset(plug);
  return {};
}

// What is missing in an attribute that is to be added, or contradicts itself; empty where all is well.
std::string addition_problem(const Node& node, const AttributeSpec& spec, const Arguments& arguments) {
  const std::string name = arguments.text("name");
  if (!is_identifier(name))
    return shown(name) + " cannot name an attribute: a letter or _, then letters, digits and _";
  if (node.schema->find(name) != no_attribute)
    return node.name + " has an attribute " + shown(name) + " already";
  if (spec.type == AttributeType::choice && spec.choices.empty())
    return "an enum needs its choices: -choices off,low:10,high";
  if (spec.type != AttributeType::choice && arguments.has("choices"))
    return "-choices is for an enum: -type enum";
  if (spec.type == AttributeType::data && spec.data_type.empty())
    return "data need the type of what connects to it: -dataType NAME";
  const auto above = [&](const char* low, const char* high) {
    const auto from = arguments.number(low), to = arguments.number(high);
    return from && to && *from > *to ? std::string("-") + low + " " + write_number(*from) + " lies above -" +
                                           high + " " + write_number(*to)
                                     : "";
  };
  const std::string range = above("min", "max");
  return range.empty() ? above("softMin", "softMax") : range;
}

Value default_of(const AttributeSpec& spec, const Arguments& arguments, const NodeNames& names) {
  const bool text = spec.type == AttributeType::string || spec.type == AttributeType::path;
  const std::vector<Word> words = text ? arguments.words("default") : split_words(arguments.text("default"));
  try {
    bool clamped = false;
    Value value = fitted(spec, read_value(spec, words, names), &clamped);
    if (clamped)
      throw GraphError(arguments.text("default") + " is out of its range (" + expectation(spec) + ")");
    return value;
  } catch (const GraphError& error) {
    throw GraphError(std::string("addAttr: -default ") + error.what());
  }
}

CommandResult add_attr(Session& session, const Arguments& arguments) {
  const Node& node = session.graph().get(arguments.text("node"));
  std::vector<Word> words = {{arguments.text("type", "float"), false}, {arguments.text("name"), false}};
  const auto property = [&](const std::string& key, const std::string& value) {
    words.push_back({key, false});
    words.push_back({value, true});
  };
  for (const char* key :
       {"min", "max", "softMin", "softMax", "choices", "dataType", "niceName", "help", "unit"})
    if (arguments.has(key)) property(key, arguments.text(key));
  for (const char* key : {"array", "hidden"})
    if (arguments.has(key)) property(key, "true");
  std::string path;
  AttributeSpec spec;
  try {
    spec = read_declaration(words, path);
  } catch (const GraphError& error) {
    throw GraphError(std::string("addAttr: ") + error.what());
  }
  if (const std::string problem = addition_problem(node, spec, arguments); !problem.empty())
    throw GraphError("addAttr: " + problem);
  if (arguments.has("default")) spec.default_value = default_of(spec, arguments, session.graph().names());
  return {session.graph().name_of(session.editor().add_attribute(node.id, spec))};
}

CommandResult lock_attr(Session& session, const Arguments& arguments) {
  for (const Plug& plug : matching_inputs(session.graph(), arguments.texts("plugs")))
    session.editor().lock(plug, !arguments.has("off"));
  return {};
}

}  // namespace

void add_attribute_commands(CommandRegistry& commands) {
  using enum ArgumentKind;
  commands.add(
      {.name = "setAttr",
       .help = "Sets an attribute, an element or a component.",
       .parameters = {{"plug", plug,
                       "node.attribute, with [element] and .x or .r; both may be patterns with * and "
                       "?"},
                      {"value", value, "as the attribute spells it: 0.5, 1 0 0, ash, 35mm, \"text\"", false,
                       true}},
       .run = set_attr});
  commands.add(
      {.name = "getAttr",
       .help = "Answers with the value of an attribute, evaluated where it is driven.",
       .parameters = {{"plug", plug,
                       "node.attribute, or a node for all that can be set on it; of a compound, an "
                       "array or a node a line for each part, of a pattern as *.visibility a line for "
                       "each that matches"}},
       .flags = {{"time", "at another frame", number}, {"lock", "whether it is locked instead", {}}},
       .run = get_attr});
  commands.add({.name = "resetAttr",
                .help = "Puts attributes back to their defaults; elements of arrays cease to exist.",
                .parameters = {{"plugs", plug, "node.attribute, or patterns as *.visibility", false, true}},
                .run = reset_attr});
  commands.add(
      {.name = "addAttr",
       .help = "Gives a node an attribute of its own.",
       .parameters = {{"node", node, "its name"}, {"name", text, "of the attribute"}},
       .flags = {{"type",
                  "bool, int, float, double, enum, string, path, float2, float3, float4, colour, matrix, "
                  "distance, angle, time, node, ramp or data (float)",
                  text},
                 {"default", "value that it begins with", value},
                 {"min", "hard minimum", number},
                 {"max", "hard maximum", number},
                 {"softMin", "left end of the slider", number},
                 {"softMax", "right end of the slider", number},
                 {"choices", "of an enum: off,low:10,high", text},
                 {"dataType", "of data: what connects to it", text},
                 {"niceName", "as the interface shows it", text},
                 {"help", "one sentence", text},
                 {"unit", "of the value", text},
                 {"array", "holds elements", {}},
                 {"hidden", "is not shown", {}}},
       .run = add_attr});
  commands.add({.name = "lockAttr",
                .help = "Locks attributes: they can neither be set nor connected.",
                .parameters = {{"plugs", plug, "node.attribute, or patterns as *.visibility", false, true}},
                .flags = {{"off", "unlocks them", {}}},
                .run = lock_attr});
}

}  // namespace plinian::graph
