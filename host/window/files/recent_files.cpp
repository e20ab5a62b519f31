// Reads, adds, writes.
#include "host/window/files/recent_files.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include "core/files/atomic_file.h"
#include "core/media/frame_sequence.h"

namespace plinian::window {

namespace fs = std::filesystem;

RecentFiles::RecentFiles(fs::path file) : file_(std::move(file)) {}

std::vector<std::string> RecentFiles::read() const {
  std::vector<std::string> paths;
  std::ifstream file(file_);
  for (std::string line; std::getline(file, line);)
    if (!line.empty()) paths.push_back(line);
  return paths;
}

void RecentFiles::write(const std::vector<std::string>& paths) const {
  if (file_.empty()) return;
  std::string text;
  for (const std::string& path : paths) text += path + "\n";
  std::error_code ignored;
  fs::create_directories(file_.parent_path(), ignored);
  try {
    write_file(file_.string(), std::string_view(text));
  } catch (const FileError&) {
    // The list is a convenience.
  }
}

void RecentFiles::add(const std::string& path) {
  constexpr std::size_t most = 12;
  const std::string whole = fs::absolute(path).lexically_normal().string();
  if (whole.find('\n') != whole.npos) return;
  std::vector<std::string> paths = read();
  std::erase(paths, whole);
  paths.insert(paths.begin(), whole);
  if (paths.size() > most) paths.resize(most);
  write(paths);
}

std::vector<std::string> RecentFiles::all() const {
  std::vector<std::string> paths = read();
  std::erase_if(paths, [](const std::string& path) {
    std::error_code error;
    return !FramePattern::parse(path) && !fs::exists(path, error);
  });
  return paths;
}

void RecentFiles::clear() {
  write({});
}

}  // namespace plinian::window
