// Parameters in words.
#include "core/scene/parameter.h"

#include <fmt/format.h>

#include "core/scene/nearest_word.h"

namespace plinian {

namespace {

// " from 2 to 16", " >= 0", " in (0, 1]", or nothing where every number will do.
std::string range_text(const ParameterRange& range) {
  const ParameterRange all;
  const bool low = range.minimum > all.minimum, high = range.maximum < all.maximum;
  if (low && high && !range.open_minimum && !range.open_maximum)
    return fmt::format(" from {} to {}", range.minimum, range.maximum);
  if (low && high)
    return fmt::format(" in {}{}, {}{}", range.open_minimum ? '(' : '[', range.minimum, range.maximum,
                       range.open_maximum ? ')' : ']');
  if (low) return fmt::format(" {} {}", range.open_minimum ? ">" : ">=", range.minimum);
  if (high) return fmt::format(" {} {}", range.open_maximum ? "<" : "<=", range.maximum);
  return "";
}

}  // namespace

std::string expectation(const ParameterSpec& spec) {
  switch (spec.type) {
    case ParameterType::boolean:
      return "true or false";
    case ParameterType::integer:
      return "an integer" + range_text(spec.range);
    case ParameterType::real:
      return "a number" + range_text(spec.range);
    case ParameterType::choice:
      return "one of " + join(spec.choices);
    case ParameterType::text:
      return "a text";
    case ParameterType::real2:
      return "2 numbers" + range_text(spec.range);
    case ParameterType::real3:
      return (spec.grey ? "a number or 3 numbers" : "3 numbers") + range_text(spec.range);
  }
  return "";
}

std::string to_text(const ParameterSpec& spec, const ParameterValue& value) {
  // Through float: fields are floats, and 0.1f should read 0.1.
  const auto number = [](double x) { return fmt::format("{}", float(x)); };
  switch (spec.type) {
    case ParameterType::boolean:
      return std::get<bool>(value) ? "true" : "false";
    case ParameterType::integer:
      return fmt::format("{}", std::get<int>(value));
    case ParameterType::real:
      return number(std::get<double>(value));
    case ParameterType::choice:
      return spec.choices.at(std::size_t(std::get<int>(value)));
    case ParameterType::text:
      return std::get<std::string>(value);
    case ParameterType::real2: {
      const dvec2 v = std::get<dvec2>(value);
      return number(v.x) + "," + number(v.y);
    }
    case ParameterType::real3: {
      const dvec3 v = std::get<dvec3>(value);
      return number(v.x) + "," + number(v.y) + "," + number(v.z);
    }
  }
  return "";
}

}  // namespace plinian
