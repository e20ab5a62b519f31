// What the command palette finds, and in which order.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "host/scene/workspace.h"
#include "host/window/files/recent_lines.h"
#include "host/window/palette/attribute_entries.h"
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
    return matching(palette_entries(session(), hotkeys_, of_plugins_), query, recent,
                    attribute_entries(session().graph(), query, 200));
  }
  std::vector<std::string> attributes(const std::string& query, std::size_t most = 200) {
    std::vector<std::string> names;
    for (const PaletteEntry& entry : attribute_entries(session().graph(), query, most))
      names.push_back(entry.field);
    return names;
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

TEST_F(PaletteEntries, AttributesAreFoundWithTheirValues) {
  session().execute("setAttr fog.density_scale 20");
  const PaletteEntry density = found("density").at(0);
  EXPECT_EQ(density.id(), "attribute fog.density_scale");
  EXPECT_EQ(density.detail, "20");
  EXPECT_EQ(density.line, "select fog");
  EXPECT_EQ(density.field, "fog.density_scale");
  session().execute("setAttr framer.rotate -40 30 0");
  EXPECT_EQ(found("rotate").at(0).id(), "action rotate");
  EXPECT_EQ(found("framer rotate").at(0).detail, "-40 30 0 degrees");
  EXPECT_EQ(found("framer.expo").at(0).field, "framer.exposure");
  EXPECT_EQ(found("framer exposure").at(0).field, "framer.exposure") << "in words, too";
  EXPECT_EQ(found("exposure framer").at(0).field, "framer.exposure");
  session().execute("lockAttr framer.exposure");
  session().execute("setKeyframe fog.g -time 1 -value 0.5");
  EXPECT_EQ(found("framer.exposure").at(0).detail, "0 stops, locked");
  session().execute("setAttr fog.phase henyey_greenstein");
  EXPECT_TRUE(found("fog.g").at(0).detail.starts_with("driven by ")) << found("fog.g").at(0).detail;
}

TEST_F(PaletteEntries, ANodeNamesAllItsAttributesByADot) {
  const auto all = attributes("fog.");
  EXPECT_GT(all.size(), 8u);
  for (const std::string& name : all) EXPECT_TRUE(name.starts_with("fog.")) << name;
  EXPECT_TRUE(attributes("fog").empty()) << "its name alone is the node's";
  EXPECT_TRUE(attributes("d").empty()) << "a letter names too many";
  EXPECT_EQ(found("fog").at(0).id(), "node fog");
  // What has no row just now cannot be shown, and neither can what is no input.
  EXPECT_EQ(std::count(all.begin(), all.end(), "fog.sigma_s"), 0);
  EXPECT_EQ(std::count(all.begin(), all.end(), "fog.out"), 0);
  EXPECT_EQ(std::count(all.begin(), all.end(), "fog.look_hash"), 0);
}

TEST_F(PaletteEntries, AttributesOfWhatIsSelectedStandBeforeOthersAndBehindActionsAndNodes) {
  session().execute("createNode directionalLight -name rim");
  session().execute("select framer");
  EXPECT_EQ(attributes("exposure").at(0), "framer.exposure");
  session().execute("select rim");
  EXPECT_EQ(attributes("exposure").at(0), "rim.exposure");
  EXPECT_EQ(attributes("scale").at(0), "rim.scale");
  session().execute("select fog");
  EXPECT_EQ(attributes("scale").at(0), "fog.density_scale") << "its own, though others fit as well";
  session().execute("createNode transform -name exposure");
  EXPECT_EQ(found("exposure").at(0).id(), "node exposure");
  EXPECT_EQ(found("undo").at(0).kind, "action");
}

TEST_F(PaletteEntries, AreFoundAtOnceAmongTenThousandNodes) {
  session().execute("delete fog framer");
  for (int i = 0; i < 10000; ++i) session().execute("createNode directionalLight");
  session().execute("createNode medium -name fog");
  session().execute("createNode directionalLight -name last");
  const auto entries = palette_entries(session(), hotkeys_, of_plugins_);
  for (const char* query : {"density", "exposure", "ex", "fog density", "light77.exp"}) {
    const auto begin = std::chrono::steady_clock::now();
    const auto more = attribute_entries(session().graph(), query, 200);
    const auto all = matching(entries, query, {}, more, 200);
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    printf("%s: %zu of %zu in %.1f ms\n", query, more.size(), entries.size(), ms);
    EXPECT_LE(all.size(), 200u);
    EXPECT_FALSE(more.empty()) << query;
    EXPECT_LT(ms, 1000.0) << query << ", however busy the machine is";
  }
  EXPECT_EQ(attributes("exposure").at(0), "last.exposure") << "the one that is selected, out of all";
  EXPECT_EQ(found("density").at(0).field, "fog.density_scale");
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
