// Values: names of types, zero values, hashes.
#include "host/graph/values/value.h"

#include <array>
#include <vector>

#include "core/scene/nearest_word.h"
#include "host/graph/graph_error.h"
#include "host/graph/values/words.h"

namespace plinian::graph {

namespace {

struct TypeTraits {
  const char* name;
  int components;
  bool number;
};

// In the order of AttributeType.
constexpr std::array<TypeTraits, 19> traits = {{
    {"bool", 0, true},     {"int", 0, true},       {"float", 0, true},   {"double", 0, true},
    {"enum", 0, true},     {"string", 0, false},   {"path", 0, false},   {"float2", 2, false},
    {"float3", 3, false},  {"float4", 4, false},   {"colour", 3, false}, {"matrix", 0, false},
    {"distance", 0, true}, {"angle", 0, true},     {"time", 0, true},    {"node", 0, false},
    {"ramp", 0, false},    {"compound", 0, false}, {"data", 0, false},
}};

}  // namespace

std::string_view type_name(AttributeType type) {
  return traits[std::size_t(type)].name;
}

AttributeType type_of_name(std::string_view name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < traits.size(); ++i) {
    if (name == traits[i].name) return AttributeType(i);
    names.push_back(traits[i].name);
  }
  const std::string meant = did_you_mean(name, names);
  throw GraphError("unknown attribute type " + shown(name) +
                   (meant.empty() ? "; there are: " + join(names) : meant));
}

int component_count(AttributeType type) {
  return traits[std::size_t(type)].components;
}

bool is_number(AttributeType type) {
  return traits[std::size_t(type)].number;
}

Value zero_value(AttributeType type) {
  switch (type) {
    case AttributeType::boolean:
      return false;
    case AttributeType::integer:
    case AttributeType::choice:
      return 0;
    case AttributeType::float1:
      return 0.0f;
    case AttributeType::double1:
    case AttributeType::distance:
    case AttributeType::angle:
    case AttributeType::time:
      return 0.0;
    case AttributeType::string:
    case AttributeType::path:
      return std::string();
    case AttributeType::float2:
      return vec2(0.0f);
    case AttributeType::float3:
    case AttributeType::colour:
      return vec3(0.0f);
    case AttributeType::float4:
      return vec4(0.0f);
    case AttributeType::matrix:
      return Boxed<dmat4>(dmat4(1.0));
    case AttributeType::node:
      return NodeId();
    case AttributeType::ramp:
      return Boxed<Ramp>();
    case AttributeType::compound:
    case AttributeType::data:
      break;
  }
  return std::monostate();
}

std::string_view describe(const Value& value) {
  constexpr std::array<std::string_view, std::variant_size_v<Value>> words = {
      "nothing",   "true or false", "an integer", "a number", "a number", "a text", "2 numbers",
      "3 numbers", "4 numbers",     "a matrix",   "a node",   "a ramp",   "data"};
  return words[value.index()];
}

void add_to_hash(Hasher& hasher, const Value& value) {
  hasher.add(std::uint64_t(value.index()));
  const auto add_numbers = [&](const auto& v) {
    for (int i = 0; i < v.length(); ++i) hasher.add(double(v[i]));
  };
  std::visit(
      [&](const auto& held) {
        using T = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int>)
          hasher.add(std::uint64_t(std::int64_t(held)));
        else if constexpr (std::is_same_v<T, float> || std::is_same_v<T, double>)
          hasher.add(double(held));
        else if constexpr (std::is_same_v<T, std::string>)
          hasher.add(std::string_view(held));
        else if constexpr (std::is_same_v<T, vec2> || std::is_same_v<T, vec3> || std::is_same_v<T, vec4>)
          add_numbers(held);
        else if constexpr (std::is_same_v<T, Boxed<dmat4>>)
          for (int column = 0; column < 4; ++column) add_numbers((*held)[column]);
        else if constexpr (std::is_same_v<T, NodeId>)
          hasher.add(std::uint64_t(held.value));
        else if constexpr (std::is_same_v<T, Boxed<Ramp>>)
          for (const RampPoint& point : held->points) {
            hasher.add(double(point.position));
            add_numbers(point.value);
            hasher.add(std::uint64_t(point.interpolation));
          }
        else if constexpr (std::is_same_v<T, DataPtr>) {
          if (held) hasher.add(std::string_view(held->type));
          hasher.add(held && held->content ? held->content : std::uint64_t(std::uintptr_t(held.get())));
        }
      },
      value);
}

std::size_t bytes_held(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return text->capacity();
  if (std::holds_alternative<Boxed<dmat4>>(value)) return sizeof(dmat4);
  if (const auto* ramp = std::get_if<Boxed<Ramp>>(&value)) return (*ramp)->points.size() * sizeof(RampPoint);
  if (const auto* data = std::get_if<DataPtr>(&value)) return *data ? (*data)->bytes : 0;
  return 0;
}

}  // namespace plinian::graph
