// Lines of the console broken into rows that a pane has room for.
#pragma once

#include <string>
#include <vector>

#include "host/window/console/console_log.h"

namespace plinian::window {

struct WrappedRow {
  LineKind kind = LineKind::note;
  std::string text;      // rows after a line's first are indented
  std::size_t line = 0;  // that it is of, among those that were given
};

/// columns: how many letters a row holds, at least 8 are taken. Breaks between words where there are any.
std::vector<WrappedRow> wrapped_rows(const std::deque<ConsoleLine>& lines, int columns);

}  // namespace plinian::window
