// Attributes from the declarations of core: ranges, units, help and choices stand there once.
#pragma once

#include "core/scene/parameter.h"
#include "host/sdk/plugin.h"

namespace plinian::nodes {

/// What an attribute adds to the parameter that it holds.
struct AttributeTouch {
  std::string name;                                         // empty: the parameter's
  std::string default_value;                                // as in scene files; empty: the zero value
  std::string nice_name, help, group, affects, shown_when;  // help: empty: the parameter's
  std::optional<double> soft_minimum, soft_maximum;
  double step = 0.0;
  std::string widget;
};

/// Lengths become distances, angles angles, three numbers that may be grey a colour. An open end of a range
/// becomes the nearest float inside it.
sdk::AttributeSpec attribute_of(const ParameterSpec& parameter, AttributeTouch touch);

/// As above, by the parameter's name. It must exist.
template <class T>
sdk::AttributeSpec attribute_of(const std::vector<Parameter<T>>& table, const std::string& parameter,
                                AttributeTouch touch) {
  return attribute_of(find_parameter(table, parameter)->spec, std::move(touch));
}

/// A default as scene files spell it.
std::string spelled(float number);
std::string spelled(const vec3& vector);

vec3 to_vec3(const std::array<float, 4>& vector);

}  // namespace plinian::nodes
