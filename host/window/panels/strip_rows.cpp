// One row after the other.
#include "host/window/panels/strip_rows.h"

namespace plinian::window {

namespace {

StripRows fill(const std::vector<StripWidth>& controls, float room, int most, float kept_free) {
  StripRows rows;
  float used = 0.0f;
  int row = 0;
  for (const StripWidth& control : controls) {
    const auto fits = [&] {
      const float space = row == most - 1 ? room - kept_free : room;
      return used + (used > 0.0f ? control.gap : 0.0f) + control.width <= space;
    };
    if (row >= 0 && used > 0.0f && !fits()) {
      row = row + 1 < most ? row + 1 : -1;
      used = 0.0f;
    }
    // What is wider than a whole row is cut off in any but the last, whose menu has room for it.
    if (row == most - 1 && !fits()) row = -1;
    rows.row.push_back(row);
    if (row < 0) continue;
    used += (used > 0.0f ? control.gap : 0.0f) + control.width;
    rows.count = row + 1;
  }
  return rows;
}

}  // namespace

StripRows wrap(const std::vector<StripWidth>& controls, float room, int most, float menu) {
  StripRows rows = fill(controls, room, most, 0.0f);
  if (rows.has_menu()) {
    rows = fill(controls, room, most, menu);
    rows.count = most;  // the menu stands in the last row, if alone
  }
  return rows;
}

}  // namespace plinian::window
