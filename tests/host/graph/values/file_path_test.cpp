#include "host/graph/values/file_path.h"

#include <cstdlib>

#include "tests/host/graph/message_of.h"

namespace plinian::graph {
namespace {

TEST(FilePath, ReplacesVariablesAndIsRelativeToTheScene) {
  ::setenv("PLINIAN_TEST_SHOW", "/shows/pompeii", 1);
  EXPECT_EQ(expand_path("$PLINIAN_TEST_SHOW/ash.vdb", "/scenes"), "/shows/pompeii/ash.vdb");
  EXPECT_EQ(expand_path("${PLINIAN_TEST_SHOW}2/ash.vdb", "/scenes"), "/shows/pompeii2/ash.vdb");
  EXPECT_EQ(expand_path("../ash.vdb", "/scenes/a"), "/scenes/ash.vdb");
  EXPECT_EQ(expand_path("ash.$F4.vdb", "/s"), "/s/ash.$F4.vdb");  // counts frames
  EXPECT_EQ(expand_path("", "/s"), "");
  EXPECT_EQ(message_of([] { expand_path("$PLINIAN_TEST_NONE/a", "/s"); }),
            "the environment variable PLINIAN_TEST_NONE in '$PLINIAN_TEST_NONE/a' is not set");
}

TEST(FilePath, IsRelativeToAFolderThatItIsUnder) {
  for (const auto& [typed, written] :
       {std::pair("/shots/a/ash.vdb", "ash.vdb"), std::pair("/shots/a/vdb/ash.####.vdb", "vdb/ash.####.vdb"),
        std::pair("/shots/a/b/../ash.vdb", "ash.vdb"), std::pair("/shots/a/~ash.vdb", "./~ash.vdb"),
        // Elsewhere, or not absolute: as typed.
        std::pair("/shots/ash.vdb", "/shots/ash.vdb"), std::pair("/shots/ab/ash.vdb", "/shots/ab/ash.vdb"),
        std::pair("../ash.vdb", "../ash.vdb"), std::pair("$SHOW/ash.vdb", "$SHOW/ash.vdb"),
        std::pair("/shots/a", "/shots/a"), std::pair("", "")}) {
    EXPECT_EQ(path_from(typed, "/shots/a"), written);
    EXPECT_EQ(path_from(typed, "/shots/a/"), written);
  }
  EXPECT_EQ(expand_path(path_from("/shots/a/~ash.vdb", "/shots/a"), "/moved"), "/moved/~ash.vdb");
}

}  // namespace
}  // namespace plinian::graph
