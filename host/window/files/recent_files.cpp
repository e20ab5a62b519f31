// Paths, whole and checked.
#include "host/window/files/recent_files.h"

#include <utility>

#include "core/media/frame_sequence.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most = 12;

}  // namespace

RecentFiles::RecentFiles(fs::path file) : lines_(std::move(file), most) {}

void RecentFiles::add(const std::string& path) {
  lines_.add(fs::absolute(path).lexically_normal().string());
}

std::vector<std::string> RecentFiles::all() const {
  std::vector<std::string> paths = lines_.all();
  std::erase_if(paths, [](const std::string& path) {
    std::error_code error;
    return !FramePattern::parse(path) && !fs::exists(path, error);
  });
  return paths;
}

}  // namespace plinian::window
