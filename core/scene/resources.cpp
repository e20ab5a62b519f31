// Data files relative to the executable, so that an installed tree can be moved.
#include "core/scene/resources.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>

namespace plinian {

std::filesystem::path resource_folder() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  return program.parent_path().parent_path() / "share" / "plinian";
}

namespace {

// $VARIABLE/plinian, or that folder at home. The XDG specification: a relative path in the variable is to be
// ignored.
std::filesystem::path user_folder(const char* variable, const char* at_home) {
  if (const char* xdg = std::getenv(variable); xdg && xdg[0] == '/')
    return std::filesystem::path(xdg) / "plinian";
  if (const char* home = std::getenv("HOME"); home && *home)
    return std::filesystem::path(home) / at_home / "plinian";
  return {};
}

}  // namespace

std::filesystem::path user_config_folder() {
  return user_folder("XDG_CONFIG_HOME", ".config");
}

std::filesystem::path user_state_folder() {
  return user_folder("XDG_STATE_HOME", ".local/state");
}

std::vector<std::filesystem::path> search_folders() {
  std::vector<std::filesystem::path> folders;
  if (const char* variable = std::getenv("PLINIAN_PATH")) {
    const std::string list = variable;
    for (std::size_t begin = 0; begin <= list.size();) {
      const std::size_t end = std::min(list.find(':', begin), list.size());
      // An empty or relative entry would mean the current folder, whatever that is.
      if (const std::filesystem::path folder = list.substr(begin, end - begin); folder.is_absolute())
        folders.push_back(folder);
      begin = end + 1;
    }
  }
  if (const auto user = user_config_folder(); !user.empty()) folders.push_back(user);
  if (const auto own = resource_folder(); !own.empty()) folders.push_back(own);
  return folders;
}

}  // namespace plinian
