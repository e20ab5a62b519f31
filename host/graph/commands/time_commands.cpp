// currentTime, setKeyframe, cutKey.
#include <algorithm>
#include <cmath>

#include "host/graph/commands/session.h"
#include "host/graph/graph_error.h"
#include "host/graph/model/conversion.h"

namespace plinian::graph {

namespace {

CommandResult current_time(Session& session, const Arguments& arguments) {
  // Not an edit: looking at another frame changes no scene.
  if (const auto time = arguments.number("time")) session.evaluator().set_time(*time);
  return {write_number(session.evaluator().time())};
}

// One number each: an attribute that holds a number, or the components of a vector.
std::vector<Plug> number_plugs(const Graph& graph, const Plug& plug) {
  const SchemaAttribute& attribute = graph.attribute(plug);
  const int count = component_count(attribute.spec.type);
  if (!attribute.spec.keyable) throw GraphError(graph.name_of(plug) + " cannot be animated");
  if (attribute.array != no_attribute && plug.element < 0)
    throw GraphError(graph.name_of(plug) + " is an array: name an element, as " + attribute.path + "[0]");
  if (attribute.spec.type == AttributeType::compound) {
    std::vector<Plug> all;
    for (const Plug& leaf : leaf_plugs(graph, plug))
      for (const Plug& one : number_plugs(graph, leaf)) all.push_back(one);
    return all;
  }
  if (plug.component >= 0 || is_number(attribute.spec.type)) return {plug};
  if (count == 0)
    throw GraphError(graph.name_of(plug) + " is of type " + std::string(type_name(attribute.spec.type)) +
                     ", which has no numbers to animate");
  std::vector<Plug> result;
  for (int i = 0; i < count; ++i) result.push_back({plug.node, plug.attribute, plug.element, i});
  return result;
}

// An attribute, and the numbers that it is keyed by.
struct Animatable {
  Plug plug;
  std::vector<Plug> numbers;
};

// What patterns may mean.
std::vector<Animatable> animatable_plugs(const Graph& graph, const std::vector<std::string>& patterns) {
  std::vector<Animatable> result;
  const auto takes = [&](const Plug& plug) {
    const AttributeSpec& spec = graph.attribute(plug).spec;
    return !spec.output && !spec.read_only && spec.keyable &&
           (is_number(spec.type) || component_count(spec.type) > 0);
  };
  for (const Plug& plug : matching_plugs(graph, patterns, takes))
    result.push_back({plug, number_plugs(graph, plug)});
  return result;
}

// The number that words say for a plug: a choice by its name, a length with its unit.
double number_from(Session& session, const Plug& plug, const std::vector<Word>& words) {
  const Graph& graph = session.graph();
  AttributeSpec spec = graph.attribute(plug).spec;
  if (plug.component >= 0) spec.type = AttributeType::float1;
  try {
    bool clamped = false;
    const double number = number_of(fitted(spec, read_value(spec, words), &clamped));
    if (clamped)
      session.warn(graph.name_of(plug) + " is out of its range (" + expectation(spec) + ") and is keyed at " +
                   write_number(number));
    return number;
  } catch (const GraphError& error) {
    throw GraphError("setKeyframe: " + graph.name_of(plug) + " " + error.what());
  }
}

// The animation curve that drives exactly this plug, or null.
const Node* curve_of(const Graph& graph, const Plug& plug) {
  const Input* input = graph.find(plug.node)->input(plug.attribute, plug.element, plug.component);
  const Node* source = input ? graph.find(input->source.node) : nullptr;
  return source && source->type->name() == "animCurve" ? source : nullptr;
}

// The curve is another node, but what it animates is the attribute that is locked.
void check_unlocked(const Graph& graph, const Plug& plug) {
  if (graph.find(plug.node)->is_locked(plug.attribute, plug.element))
    throw GraphError(graph.name_of(plug) + " is locked");
}

struct CurveAttributes {
  explicit CurveAttributes(const Node& curve)
      : key(curve.schema->find("key")),
        time(curve.schema->find("key.time")),
        value(curve.schema->find("key.value")),
        interpolation(curve.schema->find("key.interpolation")) {}
  AttributeIndex key, time, value, interpolation;
};

// The words of -value, also those of a vector in quotes.
std::vector<Word> value_words(const Arguments& arguments) {
  std::vector<Word> words;
  for (const Word& word : arguments.words("value"))
    for (const Word& one : split_words(word.text)) words.push_back(one);
  return words;
}

// A key of one number. Returns the name of the curve.
std::string set_one_key(Session& session, const Arguments& arguments, const Plug& plug,
                        const std::vector<Word>& words) {
  const Graph& graph = session.graph();
  Editor& editor = session.editor();
  check_unlocked(graph, plug);
  const Node* curve = curve_of(graph, plug);
  const Input* driver = graph.find(plug.node)->input(plug.attribute, plug.element, plug.component);
  if (driver && !curve)
    throw GraphError(graph.name_of(plug) + " is driven by " + graph.name_of(driver->source) +
                     ": disconnectAttr " + graph.name_of(plug) + " lets it be keyed");
  const double time = arguments.number("time").value_or(session.evaluator().time());
  const ResultPtr current = session.evaluator().evaluate(plug);
  if (current->error)
    throw GraphError(graph.name_of(plug) + ": " + session.evaluator().error_text(plug, *current));
  const double value = words.empty() ? number_of(current->value) : number_from(session, plug, words);
  NodeId id = curve ? curve->id : NodeId();
  if (!curve) {
    std::string base =
        graph.find(plug.node)->name + "_" + Graph::path_of(*graph.find(plug.node)->schema, plug);
    for (char& c : base)
      if (c == '.' || c == '[' || c == ']') c = '_';
    const NodeId time_node = session.time_node();
    id = editor.create_node(session.types().get("animCurve"), base);
    editor.connect(graph.plug(*graph.find(time_node), "out"), graph.plug(*graph.find(id), "in"));
    editor.connect(graph.plug(*graph.find(id), "out"), plug);
  }
  const CurveAttributes attributes(*graph.find(id));
  std::int32_t place = -1, next = 0;
  for (const std::int32_t element : graph.find(id)->elements(attributes.key)) {
    next = std::max(next, element + 1);
    if (number_of(graph.find(id)->value(attributes.time, element)) == time) place = element;
  }
  const bool is_new = place < 0;
  if (is_new) place = next;
  editor.set({id, attributes.time, place}, time);
  editor.set({id, attributes.value, place}, value);
  // Between off and on, and between choices, there is nothing.
  const AttributeType type = graph.attribute(plug).spec.type;
  const bool is_stepped = is_new && (type == AttributeType::boolean || type == AttributeType::choice);
  if (arguments.has("interpolation") || is_stepped) {
    const AttributeSpec& spec = (*graph.find(id)->schema)[attributes.interpolation].spec;
    try {
      editor.set({id, attributes.interpolation, place},
                 read_value(spec, arguments.has("interpolation") ? arguments.words("interpolation")
                                                                 : split_words("stepped")));
    } catch (const GraphError& error) {
      throw GraphError(std::string("setKeyframe: -interpolation: ") + error.what());
    }
  }
  return graph.find(id)->name;
}

CommandResult set_keyframe(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  const std::vector<Word> words = value_words(arguments);
  if (arguments.has("value") && words.empty()) throw GraphError("setKeyframe: -value is empty");
  CommandResult curves;
  for (const auto& [plug, numbers] : animatable_plugs(graph, arguments.texts("plugs"))) {
    // One word for each of them, or one for all.
    if (words.size() > 1 && words.size() != numbers.size())
      throw GraphError("setKeyframe: -value: " + graph.name_of(plug) + " is keyed by " +
                       std::to_string(numbers.size()) + (numbers.size() == 1 ? " number" : " numbers") +
                       ", not by " + std::to_string(words.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      std::vector<Word> own = words;
      if (words.size() > 1) own = {words[i]};
      curves.push_back(set_one_key(session, arguments, numbers[i], own));
    }
    if (const std::string why = without_effect(graph, plug); !why.empty()) session.warn(why);
  }
  return curves;
}

// The frames whose keys go.
struct TimeRange {
  double first = -INFINITY, last = INFINITY;

  explicit TimeRange(const Arguments& arguments) {
    if (arguments.has("time") && arguments.has("from"))
      throw GraphError("cutKey: -time and -from exclude each other");
    if (const auto from = arguments.number(arguments.has("time") ? "time" : "from")) first = *from;
    if (const auto to = arguments.number("to"))
      last = *to;
    else if (arguments.has("time"))
      last = first;
    if (first > last)
      throw GraphError("cutKey: the range begins at " + write_number(first) + ", behind its end at " +
                       write_number(last));
  }
  bool holds(double time) const { return time >= first && time <= last; }
};

CommandResult cut_key(Session& session, const Arguments& arguments) {
  const Graph& graph = session.graph();
  Editor& editor = session.editor();
  const TimeRange range(arguments);
  int cut = 0;
  std::vector<Plug> plugs;
  for (const auto& [plug, numbers] : animatable_plugs(graph, arguments.texts("plugs")))
    plugs.insert(plugs.end(), numbers.begin(), numbers.end());
  for (const Plug& plug : plugs) {
    const Node* curve = curve_of(graph, plug);
    if (!curve) continue;
    check_unlocked(graph, plug);
    const NodeId id = curve->id;
    const CurveAttributes attributes(*curve);
    const ResultPtr current = session.evaluator().evaluate(plug);
    const auto elements = curve->elements(attributes.key);
    int left = 0;
    for (const std::int32_t element : elements) {
      const bool inside = range.holds(number_of(graph.find(id)->value(attributes.time, element)));
      left += !inside;
      cut += inside;
      if (inside) editor.reset({id, attributes.key, element});
    }
    if (left > 0) continue;
    // The last key is gone: the attribute stays where the curve left it.
    editor.disconnect(plug);
    if (!current->error) editor.set(plug, number_of(current->value));
    if (graph.outgoing(id).empty()) editor.delete_nodes({id});
  }
  if (cut == 0) throw GraphError("cutKey: there is no key there");
  return {std::to_string(cut)};
}

}  // namespace

void add_time_commands(CommandRegistry& commands) {
  using enum ArgumentKind;
  commands.add({.name = "currentTime",
                .help = "Goes to a frame and answers with it; no edit, so that undo knows nothing of it.",
                .parameters = {{"time", number, "frame; else stays", true}},
                .run = current_time});
  commands.add(
      {.name = "setKeyframe",
       .help = "Keys attributes at the current time; the first key makes an animation curve.",
       .parameters = {{"plugs", plug,
                       "node.attribute, or patterns as sun.rotate.*; a vector is keyed by components", false,
                       true}},
       .flags = {{"time", "frame (the current one)", number},
                 {"value", "as the attribute spells it, for a vector 1 2 3 (the current one)",
                  ArgumentKind::value, false, true},
                 {"interpolation", "to the next key: stepped, linear or smooth", text}},
       .run = set_keyframe});
  commands.add({.name = "cutKey",
                .help = "Removes keys and answers how many; without its last key an attribute is free again.",
                .parameters = {{"plugs", plug, "node.attribute, or patterns as sun.*", false, true}},
                .flags = {{"time", "the key of one frame (all keys)", number},
                          {"from", "first frame of a range", number},
                          {"to", "last frame of a range", number}},
                .run = cut_key});
}

}  // namespace plinian::graph
