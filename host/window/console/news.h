// What of the console's lines is news: what the line beneath everything says for a while.
//
// An error stays until something has been done since, or long enough to be read; all of it is found in the
// console again.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "host/window/console/console_log.h"

namespace plinian::window {

class News {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Looks at what was added since the last call. To be called before each drawing. Returns whether there is
  /// something else to be said.
  bool update(const ConsoleLog& log, Time now);
  /// What is to be said; null: nothing.
  const ConsoleLine* line(Time now) const;

 private:
  std::uint64_t changes_ = 0;
  std::optional<ConsoleLine> line_;
  Time until_{};
};

/// How long a line of that kind is to be seen. [s]
double reading_time(LineKind kind);

}  // namespace plinian::window
