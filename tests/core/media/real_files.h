// The real files of other programs, which are not part of the project.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace plinian {

inline std::string real_file(const std::string& name) {
  return PLINIAN_SOURCE_DIR "/../shared/data/" + name;
}
#define PLINIAN_NEEDS_REAL_FILES() \
  if (!std::filesystem::exists(real_file("smoke.vdb"))) GTEST_SKIP() << "no real files beside the project"

}  // namespace plinian
