// What the command palette finds, and in which order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "host/scene/workspace.h"
#include "host/window/files/recent_lines.h"
#include "host/window/palette/entries.h"
#include "host/window/palette/fuzzy.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian::window {
namespace {

TEST(FuzzyScore, LettersMustComeInTheirOrder) {
  EXPECT_TRUE(fuzzy_score("fa", "frame all"));
  EXPECT_TRUE(fuzzy_score("FRALL", "frame all"));
  EXPECT_TRUE(fuzzy_score("all frame", "frame all")) << "each word by itself";
  EXPECT_FALSE(fuzzy_score("framez", "frame all"));
  EXPECT_FALSE(fuzzy_score("lla", "frame all"));
  EXPECT_EQ(fuzzy_score("", "frame all"), 0);
  EXPECT_FALSE(fuzzy_score("a", ""));
}

TEST(FuzzyScore, PrefersBeginningsRowsAndShortTexts) {
  EXPECT_GT(fuzzy_score("fa", "frame all"), fuzzy_score("fa", "default")) << "beginnings of words";
  EXPECT_GT(fuzzy_score("sa", "setAttr"), fuzzy_score("sa", "visual")) << "also within a word";
  EXPECT_GT(fuzzy_score("wip", "wipe"), fuzzy_score("wip", "worn ice pack on")) << "letters in a row";
  EXPECT_GT(fuzzy_score("key", "key"), fuzzy_score("key", "keyframes")) << "what is short";
  EXPECT_GT(fuzzy_score("undo", "undo"), fuzzy_score("undo", "round dough"));
}

class PaletteEntries : public testing::Test {
 protected:
  PaletteEntries() {
    ::setenv("PLINIAN_PATH", PLINIAN_SOURCE_DIR, 1);  // for the looks
    session().execute("createNode medium -name fog");
    session().execute("createNode directionalLight -name framer");
  }
  ~PaletteEntries() override { ::unsetenv("PLINIAN_PATH"); }
  graph::Session& session() { return workspace_.session(); }
  std::vector<PaletteEntry> found(const std::string& query, const std::vector<std::string>& recent = {}) {
    return matching(palette_entries(session(), hotkeys_, of_plugins_), query, recent);
  }
  scene::Workspace workspace_;
  Hotkeys hotkeys_;
  std::vector<sdk::MenuItem> of_plugins_;
};

TEST_F(PaletteEntries, HaveActionsWithTheirKeysCommandsNodesAndLooks) {
  EXPECT_EQ(found("frameall").at(0).id(), "action frame all");
  EXPECT_EQ(found("frameall").at(0).keys, "A");
  EXPECT_EQ(found("fog").at(0).line, "select fog");
  EXPECT_EQ(found("setattr").at(0).id(), "command setAttr");
  EXPECT_TRUE(found("setattr").at(0).is_open) << "it needs words";
  EXPECT_EQ(found("ash look").at(0).line, "preset apply \"ash\" fog");
  EXPECT_EQ(found("spotlight").at(0).line, "createNode spotLight");
  EXPECT_TRUE(found("no such thing as this").empty());
}

TEST_F(PaletteEntries, OfMenusOfPluginsRunTheirCommand) {
  of_plugins_.push_back(
      {.path = "Create/Clouds/Anvil", .command = "createNode transform", .help = "", .plugin = "sky"});
  EXPECT_EQ(found("anvil").at(0).id(), "menu Create/Clouds/Anvil");
  EXPECT_EQ(found("anvil").at(0).line, "createNode transform");
  EXPECT_FALSE(found("anvil").at(0).is_open);
}

// All that can be run at once can be run: each in a session of its own scene.
TEST_F(PaletteEntries, WhatIsNotToBeCompletedIsAWholeCommand) {
  int runs = 0;
  for (const PaletteEntry& entry : found("")) {
    if (entry.action || entry.is_open || entry.kind == "command") continue;
    EXPECT_NO_THROW(session().execute(entry.line)) << entry.line;
    ++runs;
  }
  EXPECT_GT(runs, 10);
}

TEST_F(PaletteEntries, AreFoundByWordsOfTheirHelpBehindThoseWithTheName) {
  const auto all = found("undo");
  EXPECT_EQ(all.at(0).title, "undo");
  const auto take_back = found("take back last edit");
  ASSERT_FALSE(take_back.empty());
  EXPECT_EQ(take_back.at(0).id(), "action undo");
}

TEST_F(PaletteEntries, WhatWasUsedLatelyStandsFirstAmongEquals) {
  const std::vector<std::string> recent = {"node fog", "action wipe", "action long gone"};
  const auto all = found("", recent);
  EXPECT_EQ(all[0].id(), "node fog");
  EXPECT_EQ(all[1].id(), "action wipe");
  EXPECT_EQ(all.size(), found("").size());
  EXPECT_EQ(found("frameall", {"node framer"}).at(0).id(), "action frame all") << "the better name wins";
}

TEST(RecentLines, AreKeptNewestFirstAndOnlySoMany) {
  TemporaryFolder folder;
  const auto file = folder.path() / "sub" / "palette";
  RecentLines recent(file, 20);
  EXPECT_TRUE(recent.all().empty());
  for (int i = 0; i < 50; ++i) recent.add("node n" + std::to_string(i));
  recent.add("node n45");
  const std::vector<std::string> again = RecentLines(file, 20).all();
  EXPECT_EQ(again, recent.all());
  EXPECT_EQ(again[0], "node n45");
  EXPECT_EQ(again[1], "node n49");
  EXPECT_EQ(std::count(again.begin(), again.end(), "node n45"), 1);
  EXPECT_EQ(again.size(), 20u);
}

}  // namespace
}  // namespace plinian::window
