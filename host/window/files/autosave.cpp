#include "host/window/files/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/files/atomic_file.h"

namespace plinian::window {

namespace fs = std::filesystem;

namespace {

fs::path lock_of(const fs::path& file) {
  return fs::path(file).replace_extension(".lock");
}
fs::path origin_of(const fs::path& file) {
  return fs::path(file).replace_extension(".from");
}

void remove_kept(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
  fs::remove(origin_of(file), ignored);
  fs::remove(lock_of(file), ignored);
}

// Whether a program that runs holds the file.
bool is_held(const fs::path& file) {
  const int lock = open(lock_of(file).c_str(), O_RDWR | O_CLOEXEC);
  if (lock < 0) return false;
  const bool held = flock(lock, LOCK_EX | LOCK_NB) != 0;
  close(lock);
  return held;
}

}  // namespace

Autosave::Autosave(fs::path folder) : folder_(std::move(folder)) {}

Autosave::~Autosave() {
  forget();
}

void Autosave::keep(const std::string& text, const std::string& scene_path) {
  if (folder_.empty()) return;
  if (file_.empty()) {
    std::error_code error;
    fs::create_directories(folder_, error);
    // A number of a process comes again some day: not while the file of the one before is there.
    fs::path file;
    for (int i = 0; lock_ < 0; ++i) {
      file = folder_ / (std::to_string(getpid()) + "-" + std::to_string(i) + ".plinian");
      lock_ = open(lock_of(file).c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
      if (lock_ < 0 && errno != EEXIST)
        throw FileError(folder_.string() + ": nothing can be kept there: " +
                        std::error_code(errno, std::generic_category()).message());
    }
    flock(lock_, LOCK_EX | LOCK_NB);
    file_ = file;
  }
  write_file(origin_of(file_).string(), std::string_view(scene_path));
  write_file(file_.string(), std::string_view(text));
}

void Autosave::leave() {
  if (file_.empty()) return;
  close(lock_);
  lock_ = -1;
  file_.clear();
}

void Autosave::forget() {
  if (file_.empty()) return;
  remove_kept(file_);
  close(lock_);
  lock_ = -1;
  file_.clear();
}

std::vector<Autosave::Left> Autosave::left_behind() const {
  std::vector<std::pair<fs::file_time_type, Left>> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    const fs::path& file = entry.path();
    if (file.extension() != ".plinian" || file == file_ || is_held(file)) continue;
    std::ifstream origin(origin_of(file));
    found.push_back({fs::last_write_time(file, error),
                     {file, {std::istreambuf_iterator<char>(origin), std::istreambuf_iterator<char>()}}});
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Left> result;
  for (auto& [when, left] : found) result.push_back(std::move(left));
  return result;
}

void Autosave::discard(const Left& left) {
  remove_kept(left.file);
}

}  // namespace plinian::window
