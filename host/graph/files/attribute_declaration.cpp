// Reads and writes declarations of added attributes.
#include "host/graph/files/attribute_declaration.h"

#include <algorithm>
#include <cmath>

#include "host/graph/graph_error.h"
#include "host/graph/values/value_text.h"

namespace plinian::graph {

namespace {

void write_lines(const AttributeSpec& spec, const std::string& path, std::vector<std::string>& lines) {
  std::string line(type_name(spec.type));
  line += " " + path;
  const auto add = [&](const char* key, const std::string& value) {
    line += std::string(" ") + key + " " + value;
  };
  const auto add_text = [&](const char* key, const std::string& text) {
    if (!text.empty()) add(key, quote(text));
  };
  const auto add_number = [&](const char* key, const std::optional<double>& number) {
    if (number) add(key, write_number(*number));
  };
  if (spec.array) add("array", "true");
  if (!spec.choices.empty()) {
    std::string choices;
    for (const Choice& choice : spec.choices)
      choices += (choices.empty() ? "" : ",") + choice.word + ":" + std::to_string(choice.value);
    add_text("choices", choices);
  }
  add_text("dataType", spec.data_type);
  const bool has_default = spec.type != AttributeType::compound && spec.type != AttributeType::data &&
                           spec.type != AttributeType::node && spec.default_value.index() != 0;
  if (has_default && spec.default_value != zero_value(spec.type))
    add_text("default", write_value(spec, spec.default_value));
  add_number("min", spec.minimum);
  add_number("max", spec.maximum);
  add_number("softMin", spec.soft_minimum);
  add_number("softMax", spec.soft_maximum);
  if (!spec.keyable) add("keyable", "false");
  if (spec.hidden) add("hidden", "true");
  add_text("niceName", spec.nice_name);
  add_text("help", spec.help);
  add_text("unit", spec.unit);
  lines.push_back(line);
  for (const AttributeSpec& child : spec.children) write_lines(child, path + "." + child.name, lines);
}

bool read_flag(const Word& word) {
  return std::get<bool>(read_value({.name = "flag", .type = AttributeType::boolean}, std::span(&word, 1)));
}

}  // namespace

std::vector<std::string> write_declaration(const AttributeSpec& spec) {
  std::vector<std::string> lines;
  write_lines(spec, spec.name, lines);
  return lines;
}

AttributeSpec read_declaration(std::span<const Word> words, std::string& path) {
  if (words.size() < 2 || words.size() % 2 != 0)
    throw GraphError("an added attribute needs a type, a name, and pairs of a property and its value");
  AttributeSpec spec;
  spec.type = type_of_name(words[0].text);
  path = words[1].text;
  spec.name = path.substr(path.rfind('.') + 1);
  const Word* default_value = nullptr;
  for (std::size_t i = 2; i < words.size(); i += 2) {
    const std::string& key = words[i].text;
    const Word& value = words[i + 1];
    if (key == "array")
      spec.array = read_flag(value);
    else if (key == "choices")
      spec.choices = read_choices(value.text);
    else if (key == "dataType")
      spec.data_type = value.text;
    else if (key == "default")
      default_value = &value;
    else if (key == "min")
      spec.minimum = read_number(value.text);
    else if (key == "max")
      spec.maximum = read_number(value.text);
    else if (key == "softMin")
      spec.soft_minimum = read_number(value.text);
    else if (key == "softMax")
      spec.soft_maximum = read_number(value.text);
    else if (key == "keyable")
      spec.keyable = read_flag(value);
    else if (key == "hidden")
      spec.hidden = read_flag(value);
    else if (key == "niceName")
      spec.nice_name = value.text;
    else if (key == "help")
      spec.help = value.text;
    else if (key == "unit")
      spec.unit = value.text;
    else
      throw GraphError("unknown property " + shown(key) + " of an added attribute");
  }
  if (default_value) spec.default_value = read_value(spec, split_words(default_value->text));
  return spec;
}

void add_declaration(std::vector<AttributeSpec>& specs, const std::string& path, AttributeSpec spec) {
  std::vector<AttributeSpec>* into = &specs;
  std::size_t begin = 0;
  for (std::size_t dot; (dot = path.find('.', begin)) != path.npos; begin = dot + 1) {
    const std::string name = path.substr(begin, dot - begin);
    const auto compound = std::find_if(into->begin(), into->end(),
                                       [&](const AttributeSpec& other) { return other.name == name; });
    if (compound == into->end() || compound->type != AttributeType::compound)
      throw GraphError("there is no compound for the added attribute " + shown(path));
    into = &compound->children;
  }
  into->push_back(std::move(spec));
}

std::vector<Choice> read_choices(const std::string& text) {
  std::vector<Choice> choices;
  int next = 0;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::size_t colon = part.find(':');
    if (colon != part.npos) {
      const double number = read_number(part.substr(colon + 1));
      if (number != std::floor(number) || std::abs(number) > 1e9)
        throw GraphError("a choice's number is an integer");
      next = int(number);
    }
    choices.push_back({next++, part.substr(0, colon), ""});
    begin = end + 1;
  }
  return choices;
}

}  // namespace plinian::graph
