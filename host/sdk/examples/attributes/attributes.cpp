// One attribute of every type: how it is declared, and how a compute function reads it.
#include <sstream>

#include "host/sdk/plugin.h"

using namespace plinian::sdk;

namespace {

// Opaque data: a list of words, which scenes hold as one text.
struct Words {
  std::vector<std::string> words;
};

DataType word_list() {
  return DataType::of<Words>(
      "wordList",
      [](const Words& list) {
        std::string text;
        for (const std::string& word : list.words) text += (text.empty() ? "" : " ") + word;
        return text;
      },
      [](std::string_view bytes) {
        auto list = std::make_unique<Words>();
        std::istringstream text{std::string(bytes)};
        for (std::string word; text >> word;) list->words.push_back(word);
        return list;
      });
}

NodeType every_type() {
  NodeType type("everyType");
  const auto add = [&](AttributeSpec spec) {
    spec.affects = "report";
    return type.add(spec);
  };
  const Attribute a_bool = add({.name = "a_bool", .type = "bool"});
  const Attribute an_int = add({.name = "an_int", .type = "int", .minimum = -100.0, .maximum = 100.0});
  const Attribute a_float = add({.name = "a_float", .type = "float"});
  const Attribute a_double = add({.name = "a_double", .type = "double"});
  const Attribute an_enum = add({.name = "an_enum", .type = "enum", .choices = "off,low:10,high"});
  const Attribute a_string = add({.name = "a_string", .type = "string"});
  const Attribute a_path = add({.name = "a_path", .type = "path"});
  const Attribute a_float2 = add({.name = "a_float2", .type = "float2"});
  const Attribute a_float3 = add({.name = "a_float3", .type = "float3"});
  const Attribute a_float4 = add({.name = "a_float4", .type = "float4"});
  const Attribute a_colour = add({.name = "a_colour", .type = "colour"});
  const Attribute a_matrix = add({.name = "a_matrix", .type = "matrix"});
  const Attribute a_distance = add({.name = "a_distance", .type = "distance", .unit = "m"});
  const Attribute an_angle = add({.name = "an_angle", .type = "angle"});
  const Attribute a_time = add({.name = "a_time", .type = "time"});
  add({.name = "a_node", .type = "node"});
  const Attribute a_ramp = add({.name = "a_ramp", .type = "ramp", .default_value = "0:0:linear 1:1:linear"});
  const AttributeSpec compound_spec = {.name = "a_compound",
                                       .type = "compound",
                                       .affects = "report",
                                       .children = {{.name = "size"}, {.name = "label", .type = "string"}}};
  const Attribute a_compound = type.add(compound_spec);
  const Attribute size = NodeType::child(a_compound, compound_spec, "size");
  const Attribute label = NodeType::child(a_compound, compound_spec, "label");
  const Attribute an_array = add({.name = "an_array", .array = true});
  const Attribute a_datum = add({.name = "a_datum", .type = "data", .data_type = "wordList"});
  const Attribute report = type.add({.name = "report", .type = "string", .output = true});

  type.compute = [=](Context& context, Attribute) {
    std::ostringstream text;
    text << context.number(a_bool) << ' ' << context.number(an_int) << ' ' << context.number(a_float) << ' '
         << context.number(a_double) << ' ';
    text << context.number(an_enum) << ' ';  // the number of the choice: 0, 10 or 11
    text << context.text(a_string) << ' ';
    text << context.text(a_path) << ' ';  // whole, with variables filled in
    for (const float number : context.vector(a_float2)) text << number << ' ';  // behind its numbers: 0
    for (const float number : context.vector(a_float3)) text << number << ' ';
    for (const float number : context.vector(a_float4)) text << number << ' ';
    for (const float number : context.vector(a_colour)) text << number << ' ';
    text << context.matrix(a_matrix)[12] << ' ';          // column by column: x of the translation
    text << context.number(a_distance) << ' '             // [m]
         << context.number(an_angle) << ' '               // [degrees]
         << context.number(a_time) << ' ';                // [frames]
    text << context.sample_ramp(a_ramp, 0.5f)[0] << ' ';  // without points: 0
    text << context.number(size) << ' ' << context.text(label) << ' ';
    for (const std::int32_t element : context.elements(an_array))  // those that were set or are connected
      text << element << ':' << context.number(an_array, element) << ' ';
    const auto* list = static_cast<const Words*>(context.data(a_datum));  // null where nothing was set
    text << (list ? list->words.size() : 0);
    context.set(report, text.str());
  };
  return type;
}

void initialise(Plugin& plugin) {
  plugin.add(word_list());
  plugin.add(every_type());
}

}  // namespace

PLINIAN_PLUGIN("attributes", "1.0", "A. Artist", "node:everyType data:wordList", initialise);
