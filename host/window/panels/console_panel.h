// The console: what was done, as commands, and a line to type more.
#pragma once

#include <string>
#include <vector>

#include "host/window/console/wrapped_rows.h"
#include "host/window/panels/widgets.h"
#include "host/window/studio.h"

struct ImGuiInputTextCallbackData;

namespace plinian::window {

class ConsolePanel {
 public:
  void show(Studio& studio, const PaneRect& pane);

 private:
  int edit(Studio& studio, ImGuiInputTextCallbackData& data);

  char line_[1024] = "";
  std::string seen_;                // what stands in it while it is typed into
  std::vector<std::string> typed_;  // oldest first
  std::size_t recalled_ = 0;        // place in typed_; its size: a new line
  bool to_end_ = false;             // the cursor goes behind what was typed ahead
  std::uint64_t shown_ = 0;         // changes of the log that were scrolled to
  // Of the log at that change, for a pane that wide [letters].
  std::vector<WrappedRow> rows_;
  std::uint64_t wrapped_ = 0;
  int columns_ = 0;
};

}  // namespace plinian::window
