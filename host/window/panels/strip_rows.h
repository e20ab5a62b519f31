// Where the controls of a strip go that is too narrow for one row of them.
#pragma once

#include <vector>

namespace plinian::window {

struct StripWidth {
  float width = 0.0f;  // [points]
  float gap = 0.0f;    // [points] before it, where it is not the first of its row
};

struct StripRows {
  std::vector<int> row;  // of each control; -1: in the menu at the end of the last row
  int count = 1;         // of rows
  bool has_menu() const { return !row.empty() && row.back() < 0; }
};

/// Puts controls in order into rows of `room`, each as far as it goes; what does not fit into `most` rows
/// goes to a menu, for which the last row keeps `menu` free. room, menu: [points].
StripRows wrap(const std::vector<StripWidth>& controls, float room, int most, float menu);

}  // namespace plinian::window
