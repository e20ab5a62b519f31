// Conversions along connections.
#include "host/graph/model/conversion.h"

#include <cmath>

#include "host/graph/graph_error.h"

namespace plinian::graph {

namespace {

bool measures(AttributeType type) {
  return type == AttributeType::distance || type == AttributeType::angle || type == AttributeType::time;
}

bool is_text(AttributeType type) {
  return type == AttributeType::string || type == AttributeType::path;
}

// Assigns a number to one place of any vector.
template <class Vector>
bool replace(Value& value, int component, double number) {
  auto* vector = std::get_if<Vector>(&value);
  if (!vector || component >= vector->length()) return false;
  (*vector)[component] = float(number);
  return true;
}

}  // namespace

std::string connection_problem(const AttributeSpec& source, bool source_component,
                               const AttributeSpec& destination, bool destination_component) {
  const AttributeType from = source_component ? AttributeType::float1 : source.type;
  const AttributeType to = destination_component ? AttributeType::float1 : destination.type;
  if (from == AttributeType::compound || to == AttributeType::compound)
    return "compounds are connected child by child";
  const std::string types = std::string(type_name(from)) + " cannot drive " + std::string(type_name(to));
  if (from == AttributeType::data && to == AttributeType::data)
    return source.data_type == destination.data_type
               ? ""
               : "data of type " + source.data_type + " cannot drive data of type " + destination.data_type;
  if (from == to || (is_text(from) && is_text(to))) return "";
  if (is_number(from) && is_number(to))
    return measures(from) && measures(to) ? types + ": they measure different things" : "";
  const int count = component_count(from);
  if (count > 0 && count == component_count(to)) return "";
  return types + (count > 0 || component_count(to) > 0 ? "; a component may be named as .x or .r" : "");
}

double number_of(const Value& value) {
  if (const auto* held = std::get_if<double>(&value)) return *held;
  if (const auto* held = std::get_if<float>(&value)) return *held;
  if (const auto* held = std::get_if<int>(&value)) return *held;
  if (const auto* held = std::get_if<bool>(&value)) return *held ? 1.0 : 0.0;
  throw GraphError("expects a number, not " + std::string(describe(value)));
}

Value converted(const Value& value, const AttributeSpec& destination) {
  if (!is_number(destination.type)) {
    // Data that are not there yet are no mistake.
    if (std::holds_alternative<std::monostate>(value)) return value;
    return fitted(destination, value);
  }
  const double number = number_of(value);
  if (destination.type == AttributeType::boolean) return number != 0.0;
  const bool whole = destination.type == AttributeType::integer || destination.type == AttributeType::choice;
  return fitted(destination, whole ? std::round(number) : number);
}

Value component_of(const Value& value, int component) {
  if (component < 0) return value;
  if (const auto* v = std::get_if<vec2>(&value)) return (*v)[component];
  if (const auto* v = std::get_if<vec3>(&value)) return (*v)[component];
  if (const auto* v = std::get_if<vec4>(&value)) return (*v)[component];
  throw GraphError("expects a vector, not " + std::string(describe(value)));
}

Value with_component(const Value& vector, int component, double number) {
  Value result = vector;
  if (!replace<vec2>(result, component, number) && !replace<vec3>(result, component, number) &&
      !replace<vec4>(result, component, number))
    throw GraphError("expects a vector, not " + std::string(describe(vector)));
  return result;
}

}  // namespace plinian::graph
