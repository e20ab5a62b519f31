// From core's parameters to attributes.
#include "host/nodes/core_attributes.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace plinian::nodes {

namespace {

std::string type_of(const ParameterSpec& parameter) {
  switch (parameter.type) {
    case ParameterType::boolean:
      return "bool";
    case ParameterType::integer:
      return "int";
    case ParameterType::choice:
      return "enum";
    case ParameterType::text:
      return "string";
    case ParameterType::real2:
      return "float2";
    case ParameterType::real3:
      return parameter.grey ? "colour" : "float3";
    case ParameterType::real:
      break;
  }
  return parameter.unit == "m" ? "distance" : parameter.unit == "degrees" ? "angle" : "float";
}

// Core speaks in short; the interface in sentences.
std::string sentence(std::string text) {
  if (text.empty()) return text;
  text[0] = char(std::toupper((unsigned char)text[0]));
  return text.back() == '.' ? text : text + ".";
}

}  // namespace

std::string spelled(float number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

std::string spelled(const vec3& vector) {
  return spelled(vector.x) + " " + spelled(vector.y) + " " + spelled(vector.z);
}

vec3 to_vec3(const std::array<float, 4>& vector) {
  return {vector[0], vector[1], vector[2]};
}

sdk::AttributeSpec attribute_of(const ParameterSpec& parameter, AttributeTouch touch) {
  sdk::AttributeSpec spec;
  spec.name = touch.name.empty() ? parameter.name : touch.name;
  spec.type = type_of(parameter);
  spec.default_value = touch.default_value;
  spec.nice_name = touch.nice_name;
  spec.help = sentence(touch.help.empty() ? parameter.help : touch.help);
  spec.unit = parameter.unit;
  spec.group = touch.group;
  spec.affects = touch.affects;
  spec.shown_when = touch.shown_when;
  spec.soft_minimum = touch.soft_minimum;
  spec.soft_maximum = touch.soft_maximum;
  spec.step = touch.step;
  spec.widget = touch.widget;
  for (const std::string& choice : parameter.choices)
    spec.choices += (spec.choices.empty() ? "" : ",") + choice;
  const bool counts = parameter.type != ParameterType::boolean && parameter.type != ParameterType::choice &&
                      parameter.type != ParameterType::text;
  if (!counts) return spec;
  constexpr float largest = std::numeric_limits<float>::max();
  const auto inside = [](double end, bool open, float towards) {
    return open ? double(std::nextafter(float(end), towards)) : end;
  };
  const ParameterRange& range = parameter.range;
  if (range.minimum > -largest) spec.minimum = inside(range.minimum, range.open_minimum, largest);
  if (range.maximum < largest) spec.maximum = inside(range.maximum, range.open_maximum, -largest);
  return spec;
}

}  // namespace plinian::nodes
