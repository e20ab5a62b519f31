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

bool has_slider(const NumberRange& range) {
  return range.soft_minimum && range.soft_maximum && *range.soft_maximum > *range.soft_minimum;
}

bool is_inside(const NumberRange& range, double value) {
  return has_slider(range) && value >= *range.soft_minimum && value <= *range.soft_maximum;
}

double rounded_to(double value, double grain) {
  value = std::round(value / grain) * grain;
  if (grain >= 1.0) return value;
  const double inverse = std::round(1.0 / grain);
  return std::round(value * inverse) / inverse;
}

double within(const NumberRange& range, double value, bool inside) {
  if (range.wraps) return wrapped(range, value);
  if (inside) value = std::clamp(value, *range.soft_minimum, *range.soft_maximum);
  if (range.minimum) value = std::max(value, *range.minimum);
  if (range.maximum) value = std::min(value, *range.maximum);
  return value;
}

// Zero is no factor of anything: from there the drag begins at the least there is.
double dragged_factor(const NumberRange& range, double start, double points, DragPace pace) {
  constexpr double per_doubling = 75.0;  // [points]
  if (pace == DragPace::fine) points *= 0.1;
  if (pace == DragPace::coarse) points *= 10.0;
  if (start <= 0.0) start = range.soft_minimum.value_or(0.01);
  const double value = start * std::exp2(std::clamp(points / per_doubling, -60.0, 60.0));
  const double digits = pace == DragPace::fine ? 1e-3 : 1e-2;
  return within(range, rounded_to(value, power_of_ten_under(value) * digits), is_inside(range, start));
}

}  // namespace

double wrapped(const NumberRange& range, double value) {
  const double turn = *range.soft_maximum - *range.soft_minimum;
  return value - turn * std::floor((value - *range.soft_minimum) / turn);
}

NumberRange range_of(const graph::AttributeSpec& spec) {
  NumberRange range{spec.minimum,
                    spec.maximum,
                    spec.soft_minimum,
                    spec.soft_maximum,
                    spec.type == graph::AttributeType::integer,
                    spec.layout.widget == "factor",
                    false,
                    spec.step};
  // A range that is closed on both sides is its own slider.
  if (!range.soft_minimum && (range.soft_maximum || range.maximum)) range.soft_minimum = range.minimum;
  if (!range.soft_maximum && range.soft_minimum) range.soft_maximum = range.maximum;
  return range;
}

double dragged(const NumberRange& range, double start, double points, DragPace pace) {
  if (range.factor) return dragged_factor(range, start, points, pace);
  const bool slider = has_slider(range), inside = is_inside(range, start);
  double per_point =
      slider ? (*range.soft_maximum - *range.soft_minimum) / 300.0 : std::max(std::abs(start), 1.0) / 100.0;
  if (slider && !inside) per_point = std::max(per_point, std::abs(start) / 100.0);
  if (range.whole) per_point = std::max(per_point, 0.1);
  if (pace == DragPace::fine) per_point *= 0.1;
  if (pace == DragPace::coarse) per_point *= 10.0;
  if (range.step > 0.0)
    return within(range, std::round((start + points * per_point) / range.step) * range.step, inside);
  // As round as the pace allows, so that what is read off is what was set.
  return within(range,
                rounded_to(start + points * per_point, range.whole ? 1.0 : power_of_ten_under(per_point)),
                inside);
}

std::optional<float> share_of(const NumberRange& range, double value) {
  if (!has_slider(range)) return std::nullopt;
  const bool factor = range.factor && *range.soft_minimum > 0.0;
  const auto along = [&](double v) { return factor ? std::log(std::max(v, *range.soft_minimum)) : v; };
  const double low = along(*range.soft_minimum), high = along(*range.soft_maximum);
  return float(std::clamp((along(value) - low) / (high - low), 0.0, 1.0));
}

std::string shown_number(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  return text == "-0" ? "0" : text;
}

}  // namespace plinian::window
