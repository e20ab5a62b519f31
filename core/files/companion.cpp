#include "core/files/companion.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace plinian {

std::string companion_path(const Companion& companion) {
  namespace fs = std::filesystem;
  if (const char* given = std::getenv(companion.variable); given && *given) return given;
  const fs::path relative = fs::path("libexec") / "plinian" / companion.file;
  std::error_code ignored;
  std::vector<fs::path> starts;
  Dl_info library;
  if (::dladdr(reinterpret_cast<void*>(&companion_path), &library) != 0 && library.dli_fname)
    starts.push_back(fs::canonical(library.dli_fname, ignored));
  starts.push_back(fs::read_symlink("/proc/self/exe", ignored));
  for (fs::path folder : starts)
    // Deep enough for lib/python3.x/site-packages/plinian and for a test in a build tree.
    for (int level = 0; level < 6 && folder.has_relative_path(); ++level) {
      folder = folder.parent_path();
      if (::access((folder / relative).c_str(), F_OK) == 0) return (folder / relative).string();
    }
  const fs::path installed = fs::path(PLINIAN_INSTALLED_LIBEXEC) / companion.file;
  if (::access(installed.c_str(), F_OK) == 0) return installed.string();
  throw std::runtime_error(std::string(companion.purpose) + ", " + companion.file +
                           ", was not found beside the program; set " + companion.variable + " to its path");
}

}  // namespace plinian
