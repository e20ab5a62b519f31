#include "core/image/image_files.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/files/companion.h"

namespace plinian {
namespace {

ImageError fail(const std::string& reason) {
  return ImageError("picture files cannot be used: " + reason);
}

const ImageFiles& load() {
  const std::string path = image_files_path();
  // Local: nobody else's symbols are to be resolved by the hundreds of libraries that come with it.
  void* const module = ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!module) {
    const char* reason = ::dlerror();
    throw fail(reason ? reason : path + " cannot be loaded");
  }
  const auto* table = static_cast<const ImageFiles*>(::dlsym(module, "plinian_image_files"));
  if (!table) throw fail(path + " is not a module of Plinian");
  if (std::strcmp(table->version, PLINIAN_IMAGE_FILES_VERSION) != 0)
    throw fail(path + " is of another version, " + table->version +
               " instead of " PLINIAN_IMAGE_FILES_VERSION + ": install Plinian again");
  return *table;
}

}  // namespace

std::string image_files_path() {
  std::string path;
  try {
    path = companion_path({"plinian-image-files.so", "PLINIAN_IMAGE_FILES", "their module"});
  } catch (const std::runtime_error& error) {
    throw fail(error.what());
  }
  if (::access(path.c_str(), R_OK) != 0) throw fail(path + ": " + std::strerror(errno));
  return path;
}

const ImageFiles& image_files() {
  static const ImageFiles& files = load();  // tried again after an exception
  return files;
}

}  // namespace plinian
