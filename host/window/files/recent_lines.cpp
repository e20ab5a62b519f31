// Reads, adds, writes.
#include "host/window/files/recent_lines.h"

#include <algorithm>
#include <utility>

#include "host/window/files/line_file.h"

namespace plinian::window {

RecentLines::RecentLines(std::filesystem::path file, std::size_t most)
    : file_(std::move(file)), most_(most) {}

std::vector<std::string> RecentLines::all() const {
  return read_lines(file_);
}

void RecentLines::write(const std::vector<std::string>& lines) const {
  write_lines(file_, lines);  // the list is a convenience
}

void RecentLines::add(const std::string& line) {
  if (line.empty() || line.find('\n') != line.npos) return;
  std::vector<std::string> lines = all();
  std::erase(lines, line);
  lines.insert(lines.begin(), line);
  if (lines.size() > most_) lines.resize(most_);
  write(lines);
}

}  // namespace plinian::window
