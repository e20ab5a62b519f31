// Bookmarks, places and paths as people hand them over.
#include "host/window/files/places.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "host/graph/graph_error.h"
#include "host/window/files/bookmarks.h"
#include "host/window/files/line_file.h"
#include "host/window/files/typed_path.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian::window {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

std::vector<std::string> labels(const std::vector<Place>& places) {
  std::vector<std::string> found;
  for (const Place& place : places) found.push_back(place.label);
  return found;
}

TEST(Bookmarks, AreAddedOnceRemovedAndThereTheNextTime) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "not" / "there yet" / "bookmarks";
  {
    Bookmarks bookmarks(file);
    EXPECT_TRUE(bookmarks.all().empty());
    bookmarks.add("/shots/a");
    bookmarks.add("/shots/b/");
    bookmarks.add("/shots/./a");
    bookmarks.add("relative");
    bookmarks.add("/two\nlines");
    EXPECT_EQ(bookmarks.all(), (Paths{"/shots/a", "/shots/b"}));
    EXPECT_TRUE(bookmarks.has("/shots/b"));
  }
  Bookmarks again(file);
  EXPECT_EQ(again.all(), (Paths{"/shots/a", "/shots/b"})) << "in their order";
  // Another window has added one meanwhile.
  Bookmarks(file).add("/shots/c");
  again.remove("/shots/a/");
  EXPECT_EQ(again.all(), (Paths{"/shots/b", "/shots/c"}));
  EXPECT_EQ(read_lines(file), (std::vector<std::string>{"/shots/b", "/shots/c"}));
  // A file that somebody spoiled.
  write_lines(file, {"no path", "/shots/d", "/shots/d"});
  EXPECT_EQ(Bookmarks(file).all(), Paths{"/shots/d"});
}

TEST(Bookmarks, LastAsLongAsTheProgramWhereNothingCanBeKept) {
  Bookmarks bookmarks{fs::path()};
  bookmarks.add("/shots/a");
  bookmarks.add("/shots/b");
  bookmarks.refresh();
  EXPECT_EQ(bookmarks.all(), (Paths{"/shots/a", "/shots/b"}));
}

TEST(Places, EachFolderStandsOnceAndThoseThatAreCalledAlikeAreToldApart) {
  const char* home = std::getenv("HOME");
  ASSERT_TRUE(home);
  const Places places = places_of("/show/scenes",
                                  {"/show/scenes/a.plinian", "/show/x/sim/b.####.vdb", "/show/x/sim/c.vdb",
                                   "/show/y/sim/c.vdb", "/show/other/d.vdb"},
                                  {"/show/x/sim"});
  const std::vector<std::string> fixed = labels(places.fixed);
  ASSERT_GE(fixed.size(), 2u);
  EXPECT_EQ(fixed[0], "Home");
  EXPECT_EQ(places.fixed[0].folder, home);
  EXPECT_EQ(fixed[1], "Scene");
  EXPECT_EQ(labels(places.recent), (std::vector<std::string>{"x/sim", "y/sim", "other"}))
      << "the scene's own folder is there already";
  EXPECT_EQ(labels(places.bookmarks), std::vector<std::string>{"sim"}) << "what is bookmarked stays so";
  EXPECT_EQ(labels(places_of("", {}, {"/"}).bookmarks), std::vector<std::string>{"/"});
}

TEST(TypedPath, IsTakenAsTerminalsShellsAndFileManagersGiveIt) {
  const std::string home = std::getenv("HOME");
  const auto path = [](const std::string& text) {
    const auto found = typed_path(text, "/here");
    return found ? found->string() : "no path";
  };
  EXPECT_EQ(path("/a/b.vdb"), "/a/b.vdb");
  EXPECT_EQ(path("  /a/b.vdb \n"), "/a/b.vdb");
  EXPECT_EQ(path("'/a/my smoke.vdb'"), "/a/my smoke.vdb");
  EXPECT_EQ(path("\"/a/my smoke.vdb\""), "/a/my smoke.vdb");
  EXPECT_EQ(path("/a/my\\ smoke\\(1\\).vdb"), "/a/my smoke(1).vdb");
  EXPECT_EQ(path("'/a/it'\\''s here.vdb'"), "/a/it's here.vdb");
  EXPECT_EQ(path("/a/it's.vdb"), "/a/it's.vdb");
  EXPECT_EQ(path("file:///a/my%20smoke.vdb"), "/a/my smoke.vdb");
  EXPECT_EQ(path("file://host/a/100%.vdb"), "/a/100%.vdb");
  EXPECT_EQ(path("~"), home);
  EXPECT_EQ(path("~/b.vdb"), home + "/b.vdb");
  EXPECT_EQ(path("$HOME/b.vdb"), home + "/b.vdb");
  EXPECT_EQ(path("/a/smoke.$F4.vdb"), "/a/smoke.$F4.vdb") << "frames are no variable";
  EXPECT_EQ(path("/a/b/"), "/a/b");
  EXPECT_EQ(path("/"), "/");
  EXPECT_EQ(path(".."), "/");
  EXPECT_EQ(path("sub/b.vdb"), "/here/sub/b.vdb");
  EXPECT_EQ(path("b.vdb"), "no path") << "a mere name";
  EXPECT_EQ(path(""), "no path");
  EXPECT_EQ(path("it's"), "no path");
  EXPECT_THROW(typed_path("$NOT_SET_ANYWHERE/b", "/here"), graph::GraphError);
}

TEST(TidyFolder, IsOneSpelling) {
  for (const char* folder : {"/a/b", "/a/b/", "/a/./b", "/a/b/.", "/a/c/../b/"})
    EXPECT_EQ(tidy_folder(folder), "/a/b") << folder;
  for (const char* root : {"/", "/.", "/a/.."}) EXPECT_EQ(tidy_folder(root), "/") << root;
}

}  // namespace
}  // namespace plinian::window
