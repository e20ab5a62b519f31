// Reads, adds, writes.
#include "host/window/files/recent_lines.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include "core/files/atomic_file.h"

namespace plinian::window {

namespace fs = std::filesystem;

RecentLines::RecentLines(fs::path file, std::size_t most) : file_(std::move(file)), most_(most) {}

std::vector<std::string> RecentLines::all() const {
  std::vector<std::string> lines;
  std::ifstream file(file_);
  for (std::string line; std::getline(file, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

void RecentLines::write(const std::vector<std::string>& lines) const {
  if (file_.empty()) return;
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  std::error_code ignored;
  fs::create_directories(file_.parent_path(), ignored);
  try {
    write_file(file_.string(), std::string_view(text));
  } catch (const FileError&) {
    // The list is a convenience.
  }
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
