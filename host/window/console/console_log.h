// What the console shows: commands as they ran, what they answered, notes, warnings and errors.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

namespace plinian::window {

enum class LineKind { command, answer, note, warning, error };

struct ConsoleLine {
  LineKind kind = LineKind::note;
  std::string text;
  int repeats = 1;           // how often it was said in a row
  std::uint64_t change = 0;  // of the log, by which it was said last
};

class ConsoleLog {
 public:
  void add(LineKind kind, const std::string& text);
  /// The echo of a command. Those that share a merge key and follow one another are one line, the last one:
  /// what a drag did, as one would type it. So are times that follow one another.
  void echo(const std::string& line, const std::string& merge_key);
  const std::deque<ConsoleLine>& lines() const { return lines_; }
  /// Counts what was added or replaced.
  std::uint64_t changes() const { return changes_; }
  void clear();

 private:
  std::deque<ConsoleLine> lines_;
  std::string merge_key_;  // of the last line, which is an echo
  std::uint64_t changes_ = 0;
};

}  // namespace plinian::window
