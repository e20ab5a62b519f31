// How wide the tiles of a pass are, so that whoever waits behind it never waits long: a hand that comes back,
// a window that is drawn by the same processor, a watchdog.
#pragma once

#include <algorithm>

namespace plinian::passes {

/// Tiles are as high as they are and as wide as the time allows. Of one program.
class TilePace {
 public:
  static constexpr int group_size = 16;   // [pixels]
  static constexpr int most_groups = 16;  // of a tile, in either direction

  /// Columns of groups that the next tile has: at least one.
  int columns() const { return columns_; }
  /// A tile of so many columns took so long. The next may be twice as wide at most.
  void took(int columns, double milliseconds) {
    const double wanted = columns * wanted_ms / std::max(milliseconds, 1e-3);
    columns_ = std::clamp(int(std::min(wanted, 2.0 * columns_)), 1, most_groups);
  }

 private:
  static constexpr double wanted_ms = 30.0;
  int columns_ = 4;
};

}  // namespace plinian::passes
