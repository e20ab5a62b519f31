// Describes node types.
#include "host/cli/type_description.h"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "core/scene/nearest_word.h"
#include "host/graph/values/value_text.h"

namespace plinian::cli {

using graph::AttributeSpec;
using graph::AttributeType;
using nlohmann::ordered_json;

namespace {

// Calls with every attribute that is not hidden, compounds before what is in them.
void for_attributes(const graph::Schema& schema,
                    const std::function<void(const graph::SchemaAttribute&)>& tell) {
  const std::function<void(graph::AttributeIndex)> walk = [&](graph::AttributeIndex index) {
    if (schema[index].spec.hidden) return;
    tell(schema[index]);
    for (const graph::AttributeIndex child : schema[index].children) walk(child);
  };
  for (const graph::AttributeIndex index : schema.top()) walk(index);
}

bool has_default_text(const AttributeSpec& spec) {
  return !spec.output && !spec.array && spec.type != AttributeType::compound &&
         spec.type != AttributeType::data && spec.type != AttributeType::node &&
         spec.type != AttributeType::matrix;
}

// "from 0 to 1", ">= 0", "above -1 and below 1", as errors say it; empty where there is no end.
std::string range_text(const std::optional<double>& low, const std::optional<double>& high) {
  const std::string text = graph::expectation({.name = "number", .minimum = low, .maximum = high});
  const std::string begin = "a number ";
  return text.starts_with(begin) ? text.substr(begin.size()) : "";
}

std::string shown_when(const AttributeSpec& spec) {
  if (spec.layout.shown_when.empty() || spec.layout.shown_words.empty()) return spec.layout.shown_when;
  return spec.layout.shown_when + "=" + join(spec.layout.shown_words, ",");
}

std::string attribute_text(const graph::SchemaAttribute& attribute) {
  const AttributeSpec& spec = attribute.spec;
  std::string line =
      fmt::format("  {:<32} {}{}", attribute.path, graph::type_name(spec.type), spec.array ? "[]" : "");
  if (spec.type == AttributeType::choice) line += ": " + graph::choices_text(spec);
  if (!spec.data_type.empty()) line += " of " + spec.data_type;
  if (!spec.unit.empty()) line += " [" + spec.unit + "]";
  if (spec.output) line += " (output)";
  if (has_default_text(spec)) line += " (" + graph::write_value(spec, spec.default_value) + ")";
  const auto add = [&](const char* what, const std::string& text) {
    if (!text.empty()) line += std::string(", ") + what + text;
  };
  add("", range_text(spec.minimum, spec.maximum));
  add("slider ", range_text(spec.soft_minimum, spec.soft_maximum));
  if (spec.step > 0.0) add("in steps of ", graph::write_number(spec.step));
  add("group ", spec.layout.group);
  add("shown when ", shown_when(spec));
  line += "\n";
  if (!spec.help.empty()) line += fmt::format("  {:<32}   {}\n", "", spec.help);
  return line;
}

ordered_json attribute_json(const graph::SchemaAttribute& attribute) {
  const AttributeSpec& spec = attribute.spec;
  ordered_json json = {{"path", attribute.path}, {"type", graph::type_name(spec.type)}};
  const auto add_text = [&](const char* key, const std::string& text) {
    if (!text.empty()) json[key] = text;
  };
  const auto add_number = [&](const char* key, const std::optional<double>& number) {
    if (number) json[key] = *number;
  };
  add_text("nice_name", spec.nice_name);
  add_text("help", spec.help);
  add_text("unit", spec.unit);
  add_text("group", spec.layout.group);
  if (spec.array) json["array"] = true;
  if (spec.output) json["output"] = true;
  if (spec.read_only) json["read_only"] = true;
  if (!spec.keyable) json["keyable"] = false;
  if (!spec.connectable) json["connectable"] = false;
  for (const graph::Choice& choice : spec.choices)
    json["choices"].push_back({{"word", choice.word}, {"value", choice.value}});
  add_text("data_type", spec.data_type);
  if (has_default_text(spec)) json["default"] = graph::write_value(spec, spec.default_value);
  add_number("minimum", spec.minimum);
  add_number("maximum", spec.maximum);
  add_number("soft_minimum", spec.soft_minimum);
  add_number("soft_maximum", spec.soft_maximum);
  if (spec.step > 0.0) json["step"] = spec.step;
  add_text("widget", spec.layout.widget);
  add_text("shown_when", shown_when(spec));
  return json;
}

}  // namespace

std::string type_text(const graph::NodeType& type) {
  const std::string& plugin = type.spec().plugin;
  std::string text =
      fmt::format("{}, version {}, {}: {}\n", type.name(), type.version(),
                  plugin.empty() ? "part of the program" : "of the plug-in " + plugin, type.spec().help);
  for_attributes(*type.schema(),
                 [&](const graph::SchemaAttribute& attribute) { text += attribute_text(attribute); });
  return text;
}

ordered_json type_json(const graph::NodeType& type) {
  const graph::NodeTypeSpec& spec = type.spec();
  ordered_json json = {{"name", type.name()},
                       {"version", type.version()},
                       {"plugin", spec.plugin},
                       {"help", spec.help},
                       {"hierarchical", spec.hierarchical},
                       {"holds_children", spec.holds_children},
                       {"attributes", ordered_json::array()}};
  for_attributes(*type.schema(), [&](const graph::SchemaAttribute& attribute) {
    json["attributes"].push_back(attribute_json(attribute));
  });
  return json;
}

}  // namespace plinian::cli
