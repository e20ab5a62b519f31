#include "core/files/companion.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace plinian {
namespace {

constexpr Companion reader = {"plinian-vdb-worker", "PLINIAN_TEST_COMPANION", "the reader"};

TEST(Companion, IsFoundAboveTheRunningProgramAndGivesWayToItsVariable) {
  ::unsetenv(reader.variable);
  const std::string found = companion_path(reader);
  EXPECT_TRUE(found.ends_with("/libexec/plinian/plinian-vdb-worker")) << found;
  EXPECT_TRUE(std::filesystem::exists(found));
  ::setenv(reader.variable, "/somewhere/else", 1);
  EXPECT_EQ(companion_path(reader), "/somewhere/else");
  ::setenv(reader.variable, "", 1);
  EXPECT_EQ(companion_path(reader), found);
  ::unsetenv(reader.variable);
}

TEST(Companion, ThatIsMissingIsOneLineThatSaysWhatToDo) {
  try {
    companion_path({"plinian-no-such-thing", "PLINIAN_TEST_COMPANION", "the thing"});
    FAIL() << "found";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "the thing, plinian-no-such-thing, was not found beside the program; set "
                 "PLINIAN_TEST_COMPANION to its path");
  }
}

}  // namespace
}  // namespace plinian
