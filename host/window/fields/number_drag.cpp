// Paces and ends.
#include "host/window/fields/number_drag.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plinian::window {

namespace {

// The largest power of ten that is not over it.
double power_of_ten_under(double value) {
  return std::pow(10.0, std::floor(std::log10(value)));
}

}  // namespace

NumberRange range_of(const graph::AttributeSpec& spec) {
  NumberRange range{spec.minimum, spec.maximum, spec.soft_minimum, spec.soft_maximum,
                    spec.type == graph::AttributeType::integer};
  // A range that is closed on both sides is its own slider.
  if (!range.soft_minimum && (range.soft_maximum || range.maximum)) range.soft_minimum = range.minimum;
  if (!range.soft_maximum && range.soft_minimum) range.soft_maximum = range.maximum;
  return range;
}

double dragged(const NumberRange& range, double start, double points, DragPace pace) {
  const bool slider = range.soft_minimum && range.soft_maximum && *range.soft_maximum > *range.soft_minimum;
  double per_point =
      slider ? (*range.soft_maximum - *range.soft_minimum) / 300.0 : std::max(std::abs(start), 1.0) / 100.0;
  const bool inside = slider && start >= *range.soft_minimum && start <= *range.soft_maximum;
  if (slider && !inside) per_point = std::max(per_point, std::abs(start) / 100.0);
  if (range.whole) per_point = std::max(per_point, 0.1);
  if (pace == DragPace::fine) per_point *= 0.1;
  if (pace == DragPace::coarse) per_point *= 10.0;
  double value = start + points * per_point;
  // As round as the pace allows, so that what is read off is what was set.
  const double grain = range.whole ? 1.0 : power_of_ten_under(per_point);
  value = std::round(value / grain) * grain;
  if (grain < 1.0) {
    const double inverse = std::round(1.0 / grain);
    value = std::round(value * inverse) / inverse;
  }
  if (inside) value = std::clamp(value, *range.soft_minimum, *range.soft_maximum);
  if (range.minimum) value = std::max(value, *range.minimum);
  if (range.maximum) value = std::min(value, *range.maximum);
  return value;
}

std::string shown_number(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  return text == "-0" ? "0" : text;
}

}  // namespace plinian::window
