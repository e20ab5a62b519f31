// A list, and the file that holds it.
#include "host/window/files/bookmarks.h"

#include <algorithm>
#include <utility>

#include "host/window/files/line_file.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

// "/a/b/" is "/a/b".
fs::path tidy(const fs::path& folder) {
  const fs::path path = folder.lexically_normal();
  return path.has_filename() || path == path.root_path() ? path : path.parent_path();
}

}  // namespace

Bookmarks::Bookmarks(fs::path file) : file_(std::move(file)) {
  refresh();
}

void Bookmarks::refresh() {
  if (file_.empty()) return;
  folders_.clear();
  for (const std::string& line : read_lines(file_))
    if (line[0] == '/' && !has(line)) folders_.push_back(tidy(line));
}

bool Bookmarks::has(const fs::path& folder) const {
  return std::find(folders_.begin(), folders_.end(), tidy(folder)) != folders_.end();
}

void Bookmarks::add(const fs::path& folder) {
  refresh();
  if (!folder.is_absolute() || folder.string().find('\n') != std::string::npos || has(folder)) return;
  folders_.push_back(tidy(folder));
  keep();
}

void Bookmarks::remove(const fs::path& folder) {
  refresh();
  if (std::erase(folders_, tidy(folder)) > 0) keep();
}

void Bookmarks::keep() {
  std::vector<std::string> lines;
  for (const fs::path& folder : folders_) lines.push_back(folder.string());
  write_lines(file_, lines);
}

}  // namespace plinian::window
