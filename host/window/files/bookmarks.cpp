// A list, and the file that holds it.
#include "host/window/files/bookmarks.h"

#include <algorithm>
#include <utility>

#include "host/window/files/line_file.h"
#include "host/window/files/typed_path.h"

namespace plinian::window {

namespace fs = std::filesystem;

Bookmarks::Bookmarks(fs::path file) : file_(std::move(file)) {
  refresh();
}

void Bookmarks::refresh() {
  if (file_.empty()) return;
  folders_.clear();
  for (const std::string& line : read_lines(file_))
    if (line[0] == '/' && !has(line)) folders_.push_back(tidy_folder(line));
}

bool Bookmarks::has(const fs::path& folder) const {
  return std::find(folders_.begin(), folders_.end(), tidy_folder(folder)) != folders_.end();
}

void Bookmarks::add(const fs::path& folder) {
  refresh();
  if (!folder.is_absolute() || folder.string().find('\n') != std::string::npos || has(folder)) return;
  folders_.push_back(tidy_folder(folder));
  keep();
}

void Bookmarks::remove(const fs::path& folder) {
  refresh();
  if (std::erase(folders_, tidy_folder(folder)) > 0) keep();
}

void Bookmarks::keep() {
  std::vector<std::string> lines;
  for (const fs::path& folder : folders_) lines.push_back(folder.string());
  write_lines(file_, lines);
}

}  // namespace plinian::window
