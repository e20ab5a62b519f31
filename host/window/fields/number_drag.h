// What dragging a number field makes of its value.
#pragma once

#include "host/graph/types/attribute_spec.h"

namespace plinian::window {

/// How fast a drag is.
enum class DragPace { usual, fine, coarse };

struct NumberRange {
  std::optional<double> minimum, maximum;            // hard
  std::optional<double> soft_minimum, soft_maximum;  // where a drag ends
  bool whole = false;                                // takes whole numbers only
  bool factor = false;                               // a drag multiplies: a widget "factor"
  bool wraps = false;                                // the soft ends are one place, as of an angle
  double step = 0.0;                                 // that a drag goes in, from 0; 0: as round as its pace
};
NumberRange range_of(const graph::AttributeSpec& spec);

/// The same place in a range that wraps, within it; the upper end is the lower one.
double wrapped(const NumberRange& range, double value);

/// The value after the mouse was dragged that far to the right since it was `start`. [points]. The soft range
/// is crossed in 300 points; without one, or outside of it, 100 points are the value itself, or 1. A factor
/// is doubled in 75 points, wherever it began. A drag stays within the soft range where it began there, and
/// within the hard one in any case; it lands on round numbers.
double dragged(const NumberRange& range, double start, double points, DragPace pace);

/// How far the value is along its slider [-] in [0, 1]; none where it has no soft range.
std::optional<float> share_of(const NumberRange& range, double value);

/// A number as a field shows it: at most 6 significant digits, no more than it needs.
std::string shown_number(double value, int digits = 6);

}  // namespace plinian::window
