// Data files relative to the executable, so that an installed tree can be moved.
#include "core/scene/resources.h"

#include <cstdlib>
#include <system_error>

namespace plinian {

std::filesystem::path resource_folder() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  return program.parent_path().parent_path() / "share" / "plinian";
}

std::filesystem::path user_config_folder() {
  // The XDG specification: a relative path in the variable is to be ignored.
  if (const char* xdg = std::getenv("XDG_CONFIG_HOME"); xdg && xdg[0] == '/')
    return std::filesystem::path(xdg) / "plinian";
  if (const char* home = std::getenv("HOME"); home && *home)
    return std::filesystem::path(home) / ".config" / "plinian";
  return {};
}

}  // namespace plinian
