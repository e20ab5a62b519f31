// A parameter is declared once: name, type, range, unit, help and the field that holds it. Files, --set and
// help texts derive from these declarations. Leaves out JSON (parameter_json.h), so that any header may
// include it.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/shared/glue.h"

namespace plinian {

enum class ParameterType { boolean, integer, real, choice, text, real2, real3 };

/// A range of numbers. Open ends are not part of it. The default is every finite float.
struct ParameterRange {
  double minimum = -std::numeric_limits<float>::max();
  double maximum = std::numeric_limits<float>::max();
  bool open_minimum = false, open_maximum = false;

  static ParameterRange any() { return {}; }
  static ParameterRange at_least(double low) { return {.minimum = low}; }
  static ParameterRange above(double low) { return {.minimum = low, .open_minimum = true}; }
  static ParameterRange closed(double low, double high) { return {.minimum = low, .maximum = high}; }
  static ParameterRange open(double low, double high) { return {low, high, true, true}; }
  static ParameterRange above_to(double low, double high) { return {low, high, true, false}; }

  bool contains(double value) const {
    return (open_minimum ? value > minimum : value >= minimum) &&
           (open_maximum ? value < maximum : value <= maximum);
  }
};

struct ParameterSpec {
  std::string name;  // as files and --set spell it
  ParameterType type = ParameterType::real;
  ParameterRange range;               // of each number
  std::string unit;                   // empty: none
  std::string help;                   // one line
  std::vector<std::string> choices;   // ParameterType::choice, in the order of the enumeration
  bool grey = false;                  // real3: one number stands for three equal ones
  std::vector<std::string> excludes;  // names that say the same in another way: only one may be given
};

/// The value of a parameter; a choice is the number of its word.
using ParameterValue = std::variant<bool, int, double, std::string, dvec2, dvec3>;

/// What the parameter may be, in words: "an integer from 2 to 16", "3 numbers >= 0", "one of tfm, atfm".
std::string expectation(const ParameterSpec& spec);

/// The value as --set would take it: "0.01", "atfm", "0.8,0.8,0.8".
std::string to_text(const ParameterSpec& spec, const ParameterValue& value);

template <class T>
struct Parameter {
  ParameterSpec spec;
  std::function<void(T&, const ParameterValue&)> set;
  std::function<std::optional<ParameterValue>(const T&)> get;  // empty: not given
  std::function<void(T&)> clear;                               // not given any more, where that can be
};

/// The parameter of that name, or null.
template <class T>
const Parameter<T>* find_parameter(const std::vector<Parameter<T>>& table, const std::string& name) {
  for (const Parameter<T>& parameter : table)
    if (parameter.spec.name == name) return &parameter;
  return nullptr;
}

template <class T>
std::vector<std::string> parameter_names(const std::vector<Parameter<T>>& table) {
  std::vector<std::string> names;
  for (const Parameter<T>& parameter : table) names.push_back(parameter.spec.name);
  return names;
}

namespace detail {

template <class F>
struct Unwrapped {
  using type = F;
};
template <class F>
struct Unwrapped<std::optional<F>> {
  using type = F;
};

template <class C, class M>
C class_of(M C::*);

template <auto First, auto... Rest, class T>
auto& follow(T& object) {
  if constexpr (sizeof...(Rest) == 0)
    return object.*First;
  else
    return follow<Rest...>(object.*First);
}

template <class F>
constexpr ParameterType type_of() {
  if constexpr (std::is_same_v<F, bool>) return ParameterType::boolean;
  if constexpr (std::is_same_v<F, std::string>) return ParameterType::text;
  if constexpr (std::is_enum_v<F>) return ParameterType::choice;
  if constexpr (std::is_same_v<F, vec2> || std::is_same_v<F, dvec2>) return ParameterType::real2;
  if constexpr (std::is_same_v<F, vec3> || std::is_same_v<F, dvec3>) return ParameterType::real3;
  if constexpr (std::is_integral_v<F> && !std::is_same_v<F, bool>) return ParameterType::integer;
  if constexpr (std::is_floating_point_v<F>) return ParameterType::real;
}

template <class F>
F from_value(const ParameterValue& value) {
  if constexpr (std::is_same_v<F, bool>) return std::get<bool>(value);
  if constexpr (std::is_same_v<F, std::string>) return std::get<std::string>(value);
  if constexpr (std::is_same_v<F, vec2> || std::is_same_v<F, dvec2>) return F(std::get<dvec2>(value));
  if constexpr (std::is_same_v<F, vec3> || std::is_same_v<F, dvec3>) return F(std::get<dvec3>(value));
  if constexpr (std::is_enum_v<F> || (std::is_integral_v<F> && !std::is_same_v<F, bool>))
    return F(std::get<int>(value));
  if constexpr (std::is_floating_point_v<F>) return F(std::get<double>(value));
}

template <class F>
ParameterValue to_value(const F& field) {
  if constexpr (std::is_same_v<F, bool> || std::is_same_v<F, std::string>) return field;
  if constexpr (std::is_same_v<F, vec2> || std::is_same_v<F, dvec2>) return dvec2(field);
  if constexpr (std::is_same_v<F, vec3> || std::is_same_v<F, dvec3>) return dvec3(field);
  if constexpr (std::is_enum_v<F> || (std::is_integral_v<F> && !std::is_same_v<F, bool>)) return int(field);
  if constexpr (std::is_floating_point_v<F>) return double(field);
}

}  // namespace detail

/// Declares the parameter that lives in a field, reached through member pointers:
/// parameter<&Quality::map, &MapQuality::threshold>({.name = "map.threshold", ...}). The type follows from
/// the field; a field may be a std::optional, which is empty until the parameter is given.
template <auto First, auto... Rest>
auto parameter(ParameterSpec spec) {
  using T = decltype(detail::class_of(First));
  using Field = std::remove_reference_t<decltype(detail::follow<First, Rest...>(std::declval<T&>()))>;
  using F = typename detail::Unwrapped<Field>::type;
  spec.type = detail::type_of<F>();
  Parameter<T> result{std::move(spec), {}, {}, {}};
  result.set = [](T& object, const ParameterValue& value) {
    detail::follow<First, Rest...>(object) = detail::from_value<F>(value);
  };
  result.get = [](const T& object) -> std::optional<ParameterValue> {
    const auto& field = detail::follow<First, Rest...>(object);
    if constexpr (std::is_same_v<F, Field>)
      return detail::to_value<F>(field);
    else
      return field ? std::optional(detail::to_value<F>(*field)) : std::nullopt;
  };
  result.clear = [](T& object) {
    if constexpr (!std::is_same_v<F, Field>) detail::follow<First, Rest...>(object).reset();
  };
  return result;
}

/// Sets a parameter and clears those that say the same in another way.
template <class T>
void set_parameter(const std::vector<Parameter<T>>& table, const Parameter<T>& parameter, T& object,
                   const ParameterValue& value) {
  parameter.set(object, value);
  for (const std::string& other : parameter.spec.excludes)
    if (const auto* excluded = find_parameter(table, other)) excluded->clear(object);
}

}  // namespace plinian
