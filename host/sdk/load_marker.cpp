// A mark is a file "HASH-HOST-PROCESS" in $XDG_STATE_HOME/plinian/loading that holds the library's time and
// path.
#include "host/sdk/load_marker.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "core/scene/resources.h"
#include "host/graph/values/hash.h"

namespace plinian::sdk {

namespace fs = std::filesystem;

namespace {

fs::path marker_folder() {
  const fs::path state = user_state_folder();
  return state.empty() ? state : state / "loading";
}

// Of the library and this machine: numbers of processes mean something on the same one alone.
std::string prefix_of(const fs::path& library) {
  graph::Hasher hasher;
  hasher.add(std::string_view(library.native()));
  char host[65] = "", text[96];
  ::gethostname(host, sizeof(host) - 1);
  std::snprintf(text, sizeof(text), "%016llx-%s-", static_cast<unsigned long long>(hasher.result().low),
                host);
  return text;
}

std::string time_of(const fs::path& library) {
  std::error_code error;
  const auto time = fs::last_write_time(library, error);
  return error ? "" : std::to_string(time.time_since_epoch().count());
}

// Marks that programs left which are gone.
std::vector<fs::path> left_of(const fs::path& library) {
  std::vector<fs::path> result;
  const std::string prefix = prefix_of(library);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(marker_folder(), error)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(prefix)) continue;
    const pid_t process = pid_t(std::atoi(name.c_str() + prefix.size()));
    const bool runs = process != ::getpid() && (::kill(process, 0) == 0 || errno == EPERM);
    if (!runs) result.push_back(entry.path());
  }
  return result;
}

}  // namespace

LoadMarker::LoadMarker(const fs::path& library) {
  std::error_code error;
  library_ = fs::absolute(library, error);
  const fs::path folder = marker_folder();
  if (folder.empty() || error) return;
  fs::create_directories(folder, error);
  file_ = folder / (prefix_of(library_) + std::to_string(::getpid()));
  std::ofstream(file_) << time_of(library_) << "\n" << library_.native() << "\n";
}

LoadMarker::~LoadMarker() {
  std::error_code ignored;
  if (file_.empty()) return;
  fs::remove(file_, ignored);
  for (const fs::path& file : left_of(library_)) fs::remove(file, ignored);
}

bool LoadMarker::is_left(const fs::path& library) {
  std::error_code ignored;
  const fs::path path = fs::absolute(library, ignored);
  for (const fs::path& file : left_of(path)) {
    std::string time;
    std::getline(std::ifstream(file) >> std::ws, time);
    if (time == time_of(path)) return true;
    fs::remove(file, ignored);  // it was built again
  }
  return false;
}

std::vector<std::string> LoadMarker::left() {
  std::vector<std::string> libraries;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(marker_folder(), error)) {
    std::ifstream file(entry.path());
    std::string time, path;
    if (std::getline(file, time) && std::getline(file, path) &&
        std::find(libraries.begin(), libraries.end(), path) == libraries.end() && is_left(path))
      libraries.push_back(path);
  }
  return libraries;
}

}  // namespace plinian::sdk
