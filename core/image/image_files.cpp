#include "core/image/image_files.h"

#include <dlfcn.h>

#include <cstring>

#include "core/files/companion.h"

namespace plinian {
namespace {

const ImageFiles& load() {
  const std::string path = image_files_path();
  const auto fail = [&](const std::string& reason) {
    return ImageError("picture files can neither be read nor written: " + reason);
  };
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

std::string image_files_path() try {
  return companion_path({"plinian-image-files.so", "PLINIAN_IMAGE_FILES", "the picture file module"});
} catch (const std::runtime_error& error) {
  throw ImageError(error.what());
}

const ImageFiles& image_files() {
  static const ImageFiles& files = load();  // tried again after an exception
  return files;
}

}  // namespace plinian
