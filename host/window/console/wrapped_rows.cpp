// Counts letters, not bytes.
#include "host/window/console/wrapped_rows.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace plinian::window {

namespace {

constexpr const char* indent = "  ";
constexpr std::size_t indent_columns = 2;

bool is_inside_letter(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

// How many bytes the first letters take.
std::size_t bytes_of(std::string_view text, std::size_t letters) {
  std::size_t at = 0;
  for (; letters > 0 && at < text.size(); --letters) {
    ++at;
    while (at < text.size() && is_inside_letter(text[at])) ++at;
  }
  return at;
}

// How much of the text one row takes.
std::size_t row_length(std::string_view text, std::size_t columns) {
  const std::size_t fits = bytes_of(text, columns);
  if (const std::size_t end = text.find('\n'); end <= fits) return end;
  if (fits == text.size()) return fits;
  const std::size_t space = text.rfind(' ', fits);
  return space == text.npos || space == 0 ? fits : space;
}

}  // namespace

std::vector<WrappedRow> wrapped_rows(const std::deque<ConsoleLine>& lines, int columns) {
  std::vector<WrappedRow> rows;
  const std::size_t room = std::size_t(std::max(columns, 8));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ConsoleLine& line = lines[i];
    const std::string text =
        line.repeats > 1 ? line.text + "  (" + std::to_string(line.repeats) + " times)" : line.text;
    std::string_view left = text;
    for (bool first = true; first || !left.empty(); first = false) {
      const std::size_t length = row_length(left, first ? room : room - indent_columns);
      std::string row = (first ? "" : indent) + std::string(left.substr(0, length));
      while (row.ends_with(' ')) row.pop_back();
      rows.push_back({line.kind, std::move(row), i});
      left.remove_prefix(length);
      if (!left.empty() && (left.front() == ' ' || left.front() == '\n')) left.remove_prefix(1);
    }
  }
  return rows;
}

}  // namespace plinian::window
