#include "host/sdk/load_marker.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/core/scene/temporary_folder.h"

namespace plinian::sdk {
namespace {

// Another program marks a library and is gone without coming back.
void crash_while_loading(const std::string& library) {
  const pid_t child = ::fork();
  if (child == 0) {
    const LoadMarker marker(library);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
}

TEST(LoadMarker, IsLeftByAProgramThatIsGoneAndByNoOther) {
  const TemporaryFolder own;
  ::setenv("XDG_STATE_HOME", (own / "state").c_str(), 1);
  const std::string good = own.write("good.so", "x"), bad = own.write("bad.so", "x");
  EXPECT_TRUE(LoadMarker::left().empty());
  { const LoadMarker marker(good); }
  EXPECT_FALSE(LoadMarker::is_left(good));
  crash_while_loading(bad);
  EXPECT_TRUE(LoadMarker::is_left(bad));
  EXPECT_FALSE(LoadMarker::is_left(good));
  EXPECT_EQ(LoadMarker::left(), std::vector<std::string>{bad});
  { const LoadMarker marker(bad); }  // it came back
  EXPECT_TRUE(LoadMarker::left().empty());
  ::unsetenv("XDG_STATE_HOME");
}

TEST(LoadMarker, OfAProgramThatIsLoadingStillCountsForNothing) {
  const TemporaryFolder own;
  ::setenv("XDG_STATE_HOME", (own / "state").c_str(), 1);
  const std::string library = own.write("a.so", "x");
  int ready[2], done[2];
  ASSERT_EQ(::pipe(ready) + ::pipe(done), 0);
  const pid_t child = ::fork();
  char byte = 0;
  if (child == 0) {
    const LoadMarker marker(library);
    (void)!::write(ready[1], "x", 1);
    (void)!::read(done[0], &byte, 1);
    ::_exit(0);
  }
  (void)!::read(ready[0], &byte, 1);
  EXPECT_FALSE(LoadMarker::is_left(library));
  (void)!::write(done[1], "x", 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(LoadMarker::is_left(library));
  ::unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace plinian::sdk
