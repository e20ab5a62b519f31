// The command palette: a few letters find what could be done.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/window/files/recent_lines.h"
#include "host/window/palette/entries.h"
#include "host/window/studio.h"

namespace plinian::window {

class Palette {
 public:
  Palette();
  /// Shows it while Studio::show_palette; runs commands that are chosen and returns an action that is.
  std::optional<Action> show(Studio& studio);
  /// An attribute that was chosen, whose field is to take the keys.
  std::optional<std::string> take_field() { return std::exchange(field_, std::nullopt); }

 private:
  void begin(Studio& studio);
  void show_row(Studio& studio, const PaletteEntry& entry, std::size_t row);
  void find(Studio& studio);
  void step();
  std::optional<Action> choose(Studio& studio, const PaletteEntry& entry);

  char query_[128] = "";
  std::string shown_query_;
  std::vector<PaletteEntry> entries_, found_;
  RecentLines recent_;
  std::optional<std::string> field_;
  std::size_t chosen_ = 0;  // place in found_
  bool is_open_ = false, moved_ = false;
};

}  // namespace plinian::window
