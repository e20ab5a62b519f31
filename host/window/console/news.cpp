// The newest line that is no command, while it is new.
#include "host/window/console/news.h"

#include <iterator>
#include <utility>

namespace plinian::window {

double reading_time(LineKind kind) {
  return kind == LineKind::error ? 15.0 : kind == LineKind::warning ? 10.0 : 6.0;
}

bool News::update(const ConsoleLog& log, Time now) {
  if (log.changes() == changes_) return false;
  const std::uint64_t before = std::exchange(changes_, log.changes());
  const auto& lines = log.lines();
  bool is_news = false;
  if (lines.empty()) line_.reset();
  auto line = lines.end();
  while (line != lines.begin() && std::prev(line)->change > before) --line;
  for (; line != lines.end(); ++line) {
    if (line->kind == LineKind::answer) continue;
    if (line->kind == LineKind::command) {
      // What was done since answers an error; what it had to say itself stands behind it.
      if (line_ && line_->kind == LineKind::error) line_.reset();
      continue;
    }
    line_ = *line;
    is_news = true;
    until_ = now + std::chrono::duration_cast<Time::duration>(
                       std::chrono::duration<double>(reading_time(line->kind)));
  }
  return is_news;
}

const ConsoleLine* News::line(Time now) const {
  return line_ && now < until_ ? &*line_ : nullptr;
}

}  // namespace plinian::window
