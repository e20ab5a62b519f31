// Keeps the last lines.
#include "host/window/console/console_log.h"

namespace plinian::window {

namespace {

constexpr std::size_t most_lines = 5000;

std::string subject_of(const std::string& line) {
  const auto space = line.find(' ');
  return space == line.npos ? line : line.substr(0, line.find(' ', space + 1));
}

bool sets_time(const ConsoleLine& line) {
  return line.kind == LineKind::command && line.text.starts_with("currentTime ");
}

}  // namespace

void ConsoleLog::add(LineKind kind, const std::string& text) {
  ++changes_;
  merge_key_.clear();
  if (!lines_.empty() && lines_.back().kind == kind && lines_.back().text == text) {
    ++lines_.back().repeats;
    lines_.back().change = changes_;
    return;
  }
  lines_.push_back({kind, text, 1, changes_});
  if (lines_.size() > most_lines) lines_.pop_front();
}

void ConsoleLog::echo(const std::string& line, const std::string& merge_key) {
  if (!merge_key.empty() && merge_key == merge_key_) {
    // Of several nodes that are dragged together each has a line.
    for (auto old = lines_.rbegin(); old != lines_.rend() && old->kind == LineKind::command; ++old)
      if (subject_of(old->text) == subject_of(line)) {
        ++changes_;
        old->text = line;
        old->change = changes_;
        return;
      }
  }
  // A time that runs would push everything else out of sight, and none of its steps can be undone.
  if (!lines_.empty() && sets_time(lines_.back()) && sets_time({LineKind::command, line})) lines_.pop_back();
  add(LineKind::command, line);
  lines_.back().repeats = 1;
  merge_key_ = merge_key;
}

void ConsoleLog::clear() {
  ++changes_;
  lines_.clear();
  merge_key_.clear();
}

}  // namespace plinian::window
