// Older scenes, and plug-ins that cannot migrate them.
#include <fstream>

#include "host/graph/files/scene_reader.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

// Of version 1 of the type, when half the amount was stored.
std::string old_scene(const std::string& half) {
  return R"(plinian scene 1.0
requires wobble 1.2
node wobble good
  .half 3
node wobble bad
  .half )" +
         half + R"(
  .label "as  it was"
  .more[2] 1
node wobbleTotal total
  .source <- bad.numbers
type wobble 1 from wobble 1.1
  .half 0.5
  .label "two words"
type wobbleTotal 1 from wobble 1.2
end
)";
}

struct MigrationSession : PluginSession {
  const TemporaryFolder own;
  const std::string file = own / "old.plinian", again = own / "again.plinian";
  std::vector<std::string> warnings;
  MigrationSession() {
    session.on_warning = [this](const std::string& line) { warnings.push_back(line); };
    std::ofstream(file) << old_scene("many");
  }
  std::string saved() {
    run("save \"" + again + "\"");
    return graph::read_text_file(again);
  }
};

constexpr const char* why =
    "bad cannot be migrated from version 1 of the type 'wobble': half of many is not known; nodes of the "
    "type "
    "are kept as they are: load a plug-in that can migrate them";

TEST(Migration, NodesThatCannotBeMigratedAreKeptWordForWordAndComeAliveWithAMendedPlugin) {
  MigrationSession s;
  s.run("open \"" + s.file + "\"");
  EXPECT_EQ(s.warnings, std::vector<std::string>{s.file + ": " + why});
  EXPECT_TRUE(s.session.graph().get("bad").type->is_unknown());
  // Loading what is loaded would not help.
  EXPECT_EQ(
      s.refusal("getAttr bad.amount"),
      "node 'bad' (wobble) has no attribute 'amount': it is kept as it was saved, since the plug-in 'wobble' "
      "that is loaded could not migrate it");
  EXPECT_EQ(s.saved(), old_scene("many"));
  s.run("unloadPlugin -force wobble\nloadPlugin " PLINIAN_TEST_PLUGINS "/wobble_mended.so");
  EXPECT_EQ(s.run("getAttr bad.amount\ngetAttr good.amount\ngetAttr bad.label\ngetAttr total.out"),
            "77\n6\n\"as  it was\"\n82");
  EXPECT_NE(s.saved().find("type wobble 2 from wobble 1.2\n"), std::string::npos);
}

TEST(Migration, OneThatIsLoadedLaterAndCannotMigrateLeavesTheNodesAsTheyAre) {
  MigrationSession s;
  const auto requires_none = s.session.on_requires;
  s.session.on_requires = nullptr;
  s.run("open \"" + s.file + "\"");
  s.warnings.clear();
  s.run("loadPlugin wobble");
  EXPECT_EQ(s.warnings, std::vector<std::string>{why});
  EXPECT_EQ(s.saved(), old_scene("many"));
  s.session.on_requires = requires_none;
}

TEST(Migration, ASceneHasOneVersionOfAType) {
  MigrationSession s;
  s.run("open \"" + s.file + "\"");
  EXPECT_EQ(
      s.refusal("createNode wobble"),
      "there can be no new wobble beside good, which is of version 1 of the type: load a plug-in that can "
      "migrate it, or delete it first");
  EXPECT_EQ(s.saved(), old_scene("many"));
  s.run("delete good bad\ncreateNode wobble -name new");
  EXPECT_EQ(s.saved().find(".half"), std::string::npos);
  EXPECT_EQ(s.refusal("import \"" + s.file + "\""),
            s.file + ": " + why + ", or delete new and its like first");
  std::ofstream(s.file) << old_scene("8");
  EXPECT_EQ(s.run("import \"" + s.file + "\"\ngetAttr bad.amount"), "good\nbad\ntotal1\n16");
}

TEST(Migration, AnAttributeWithAnOlderNameIsMigratedByEitherName) {
  MigrationSession s;
  std::ofstream(s.file) << R"(plinian scene 1.0
requires renamed 1.2
node renamed right
  .strength 3
node renamed removed
  .strength 4
  .how "removed"
node renamed old
  .strength 5
  .how "old name"
node renamed left
type renamed 1 from renamed 1.0
  .strength 7
  .how "right"
end
)";
  s.run("open \"" + s.file + "\"");
  EXPECT_EQ(s.warnings, std::vector<std::string>());
  EXPECT_EQ(s.run("getAttr right.amount\ngetAttr removed.amount\ngetAttr old.amount\ngetAttr left.amount"),
            "6\n8\n10\n14");
}

TEST(Migration, WhatAMigratorSetsThatCannotBeIsToldAndKept) {
  MigrationSession s;
  std::ofstream(s.file) << R"(plinian scene 1.0
requires renamed 1.2
node renamed misspelt
  .strength 3
  .how "misspelt"
node renamed word
  .strength 3
  .how "no number"
type renamed 1 from renamed 1.0
  .strength 1
  .how "right"
end
)";
  s.run("open \"" + s.file + "\"");
  ASSERT_EQ(s.warnings.size(), 2u);
  EXPECT_EQ(
      s.warnings[0],
      s.file +
          ":3: misspelt: its migration from version 1 of the type sets '.amuont 6', but node 'misspelt' "
          "(renamed) has no attribute 'amuont' (did you mean 'amount'?); the line is kept as it is");
  EXPECT_EQ(s.warnings[1],
            s.file +
                ":7: word: its migration from version 1 of the type sets '.strength twice', but "
                "word.strength expects a number, not 'twice'; the line is kept as it was");
  const std::string text = s.saved();
  EXPECT_NE(text.find("  .amuont 6\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  .strength 3\n"), std::string::npos) << text;
}

// Else the next older plug-in would neither be told of it nor kept from saving over it.
TEST(Migration, WhatAnOlderPluginSavesOfANewerOneStaysTheNewerOnes) {
  MigrationSession s;
  const std::string newer = R"(plinian scene 1.0
requires wobble 3.1
node wobble w
  .breadth 4
node wobbleTotal total
  .source <- w.numbers
type wobble 5 from wobble 3.1
  .breadth 1
type wobbleTotal 1 from wobble 1.2
end
)";
  std::ofstream(s.file) << newer;
  s.run("open \"" + s.file + "\"");
  EXPECT_NE(s.refusal("save").find("read-only"), std::string::npos);
  const std::string text = s.saved();
  EXPECT_NE(text.find("requires wobble 3.1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("type wobble 5 from wobble 3.1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  .breadth 4\n"), std::string::npos) << text;
  s.run("open \"" + s.again + "\"");
  EXPECT_NE(s.refusal("save").find("read-only"), std::string::npos) << "the next one is told as well";
}

TEST(Migration, WhatANewerPluginSaysOfATypeKeepsItsPlace) {
  MigrationSession s;
  s.run("loadPlugin wobble\ncreateNode wobble -name w");
  std::string newer = s.saved();
  for (std::size_t at; (at = newer.find("wobble 1.2")) != newer.npos;) newer.replace(at, 10, "wobble 1.7");
  const std::size_t section = newer.find("type wobble");
  for (const char* before : {"  .amount", "  .mode", "  .offset"})
    newer.insert(newer.find(before, section), "  .new_" + std::string(before + 3) + " 1\n  .and 2\n");
  newer.insert(newer.find("end\n"), "  .last 5\n");
  std::ofstream(s.file) << newer;
  s.run("open -force \"" + s.file + "\"");
  EXPECT_EQ(s.saved(), newer);
  // Nor is it lost on the way when the plug-in goes and comes.
  s.run("unloadPlugin -force wobble");
  EXPECT_EQ(s.saved(), newer);
  s.run("loadPlugin wobble");
  EXPECT_EQ(s.saved(), newer);
}

TEST(Migration, WhatANewerPluginSavedWithTheSameTypesStaysOfTheNewerOneToo) {
  MigrationSession s;
  const auto opened_and_saved = [&](const std::string& scene) {
    std::ofstream(s.file) << scene;
    s.warnings.clear();
    s.run("open -force \"" + s.file + "\"");
    const std::string text = s.saved();
    const std::vector<std::string> first = s.warnings;
    s.warnings.clear();
    s.run("open \"" + s.again + "\"");
    EXPECT_EQ(first.size(), 1u);
    EXPECT_EQ(s.warnings, std::vector<std::string>{s.again + ": was saved with version 1.7 of the plug-in "
                                                             "'wobble', here is 1.2: what is not known here "
                                                             "is kept as it is"});
    return text;
  };
  s.run("loadPlugin wobble\ncreateNode wobble -name w\ncreateNode wobbleTotal -name total");
  std::string newer = s.saved();
  for (std::size_t at; (at = newer.find("wobble 1.2")) != newer.npos;) newer.replace(at, 10, "wobble 1.7");
  EXPECT_EQ(opened_and_saved(newer), newer);
  // A scene that was written by hand says it once.
  EXPECT_NE(opened_and_saved("plinian scene 1.0\nrequires wobble 1.7\nnode wobble w\nend\n")
                .find("requires wobble 1.7\n"),
            std::string::npos);
  EXPECT_NE(opened_and_saved("plinian scene 1.0\nrequires wobble 1.7\nend\n").find("requires wobble 1.7\n"),
            std::string::npos);
  // Nor does it become an older one's by way of a session without the plug-in.
  s.run("newScene\nunloadPlugin wobble");
  s.session.on_requires = nullptr;
  std::ofstream(s.file) << newer;
  s.run("open \"" + s.file + "\"");
  EXPECT_EQ(s.saved(), newer);
  s.warnings.clear();
  s.run("loadPlugin wobble");
  ASSERT_EQ(s.warnings.size(), 2u) << "for each type";
  EXPECT_EQ(
      s.warnings[0],
      "nodes of the type 'wobble' were saved with version 1.7 of the plug-in 'wobble', here is 1.2: what "
      "is not known here is kept as it is");
  EXPECT_EQ(s.saved(), newer);
  s.run("unloadPlugin -force wobble");
  EXPECT_EQ(s.saved(), newer);
}

}  // namespace
}  // namespace plinian::sdk
