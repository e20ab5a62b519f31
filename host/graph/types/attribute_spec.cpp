// What an attribute accepts.
#include "host/graph/types/attribute_spec.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

std::optional<double> as_number(const Value& value) {
  if (const auto* held = std::get_if<bool>(&value)) return *held ? 1.0 : 0.0;
  if (const auto* held = std::get_if<int>(&value)) return *held;
  if (const auto* held = std::get_if<float>(&value)) return *held;
  if (const auto* held = std::get_if<double>(&value)) return *held;
  return std::nullopt;
}

[[noreturn]] void refuse(const AttributeSpec& spec, const Value& value) {
  throw GraphError("expects a value of type " + std::string(type_name(spec.type)) + ", not " +
                   std::string(describe(value)));
}

double clamped_number(const AttributeSpec& spec, double number, bool* clamped) {
  if (!std::isfinite(number)) throw GraphError("expects a finite number");
  double result = number;
  if (spec.minimum) result = std::max(result, *spec.minimum);
  if (spec.maximum) result = std::min(result, *spec.maximum);
  if (result != number && clamped) *clamped = true;
  return result;
}

template <class Vector>
Value fitted_vector(const AttributeSpec& spec, const Value& value, bool* clamped) {
  const auto* held = std::get_if<Vector>(&value);
  if (!held) refuse(spec, value);
  Vector result = *held;
  for (int i = 0; i < result.length(); ++i)
    result[i] = float(clamped_number(spec, double(result[i]), clamped));
  return result;
}

Value fitted_number(const AttributeSpec& spec, const Value& value, bool* clamped) {
  const auto number = as_number(value);
  if (!number) refuse(spec, value);
  double result = clamped_number(spec, *number, clamped);
  const bool whole = spec.type == AttributeType::integer || spec.type == AttributeType::choice;
  if (spec.type == AttributeType::boolean) {
    if (result != 0.0 && result != 1.0) throw GraphError("expects true or false");
    return result != 0.0;
  }
  if (whole) {
    if (result != std::floor(result) || std::abs(result) > double(std::numeric_limits<int>::max()))
      throw GraphError("expects an integer");
    if (spec.type == AttributeType::choice &&
        std::none_of(spec.choices.begin(), spec.choices.end(),
                     [&](const Choice& choice) { return choice.value == int(result); }))
      throw GraphError(std::to_string(int(result)) + " is none of " + choices_text(spec));
    return int(result);
  }
  if (spec.type != AttributeType::float1) return result;
  if (!std::isfinite(float(result))) throw GraphError("expects a number that single precision can hold");
  return float(result);
}

}  // namespace

std::string choices_text(const AttributeSpec& spec) {
  std::vector<std::string> texts;
  for (const Choice& choice : spec.choices)
    texts.push_back(choice.word + " (" + std::to_string(choice.value) + ")");
  return join(texts);
}

bool is_identifier(std::string_view word) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return !word.empty() && letter(word.front()) &&
         std::all_of(word.begin(), word.end(), [&](char c) { return letter(c) || digit(c); });
}

Value fitted(const AttributeSpec& spec, const Value& value, bool* clamped) {
  if (is_number(spec.type)) return fitted_number(spec, value, clamped);
  switch (spec.type) {
    case AttributeType::float2:
      return fitted_vector<vec2>(spec, value, clamped);
    case AttributeType::float3:
    case AttributeType::colour:
      return fitted_vector<vec3>(spec, value, clamped);
    case AttributeType::float4:
      return fitted_vector<vec4>(spec, value, clamped);
    case AttributeType::compound:
      throw GraphError("is a compound: set its children");
    case AttributeType::data: {
      const auto* data = std::get_if<DataPtr>(&value);
      if (std::holds_alternative<std::monostate>(value) || (data && !*data)) return DataPtr();
      if (!data) refuse(spec, value);
      if ((*data)->type != spec.data_type)
        throw GraphError("expects data of type '" + spec.data_type + "', not '" + (*data)->type + "'");
      return value;
    }
    default:
      if (value.index() != zero_value(spec.type).index()) refuse(spec, value);
      return value;
  }
}

}  // namespace plinian::graph
