// What the host does for the importers and exporters of plug-ins.
#include <filesystem>
#include <fstream>

#include "host/graph/files/scene_reader.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

struct ListSession : PluginSession {
  const TemporaryFolder own;
  const std::string file = own / "a.list";
  ListSession() { run("loadPlugin lists"); }
  std::string exported(const std::string& arguments) {
    run("export \"" + file + "\" " + arguments);
    return graph::read_text_file(file);
  }
};

TEST(FileType, AnExporterIsGivenTheNamesOfAllThatIsToBeWritten) {
  ListSession s;
  s.run(
      "createNode transform -name top\ncreateNode transform -name a1 -parent top\n"
      "createNode transform -name a2 -parent a1\ncreateNode animCurve -name curve\n"
      "connectAttr curve.out a2.translate.x\nselect a2");
  EXPECT_EQ(s.exported("a*"), "a1\na2\ntop\n") << "patterns, and the transforms above";
  EXPECT_EQ(s.exported(""), "a2\na1\ntop\n") << "the selection";
  EXPECT_EQ(s.exported("top"), "top\na1\na2\n") << "and what is under it";
  EXPECT_EQ(s.exported("a2 -inputs"), "a2\na1\ncurve\ntop\n");
}

TEST(FileType, WhatWasThereStaysWhereAnExporterFailsOrWritesNothing) {
  ListSession s;
  s.run(
      "createNode transform -name good\ncreateNode transform -name broken\ncreateNode transform -name "
      "nothing");
  EXPECT_EQ(s.exported("good"), "good\n");
  EXPECT_EQ(s.refusal("export \"" + s.file + "\" broken"), s.file + ": 'broken' has no name in such files")
      << "the name of the temporary file is nobody's business";
  EXPECT_EQ(s.refusal("export \"" + s.file + "\" nothing"),
            "export: the file type 'list' wrote nothing to " + s.file +
                ", which is left as it was: name nodes that it can write");
  EXPECT_EQ(s.refusal("export \"" + s.file + "\" nob*"), "no node matches 'nob*'");
  EXPECT_NE(s.refusal("export " + (s.own / "none/b.list") + " good").find("does not exist"),
            std::string::npos);
  EXPECT_EQ(graph::read_text_file(s.file), "good\n");
  const std::filesystem::directory_iterator files(s.own.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "nothing is left beside it";
}

TEST(FileType, WhoReadsAFileIsToldBeforeItIsLoaded) {
  PluginSession s;
  const TemporaryFolder own;
  // The description of a plug-in names its file type, which is called as its files end, or otherwise.
  for (const char* name : {"a.list", "b.xyz", "c.png"}) std::ofstream(own / name) << "one\n";
  EXPECT_EQ(
      s.refusal("import \"" + own / "a.list" + "\""),
      "import: " + own / "a.list" +
          ": no type of file that is read here ends in .list: the plug-in 'lists' brings it: loadPlugin "
          "lists");
  const std::string other = s.refusal("import \"" + own / "b.xyz" + "\"");
  EXPECT_NE(other.find("; plug-ins that are not loaded read others: the file type "), other.npos) << other;
  EXPECT_NE(other.find("'points': the plug-in 'extras' brings it: loadPlugin extras"), other.npos) << other;
  s.run("loadPlugin lists");
  EXPECT_EQ(s.run("import \"" + own / "a.list" + "\""), "one");
}

TEST(FileType, AnImporterThatKnowsNoNamespacesIsGivenThem) {
  ListSession s;
  std::ofstream(s.file) << "one\ntwo\n";
  EXPECT_EQ(s.run("import -namespace lib \"" + s.file + "\""), "lib:one\nlib:two");
  EXPECT_EQ(s.run("getAttr lib:two.translate.y\nls *o*"), "5\nlib:one\nlib:two");
  EXPECT_EQ(s.run("import \"" + s.file + "\""), "one\ntwo");
  s.run("undo 2");
  EXPECT_EQ(s.run("ls"), "time1");
}

TEST(FileType, WhatAnImporterThrowsIsToldWithItsFile) {
  ListSession s;
  s.run("loadPlugin extras");
  const std::string file = s.own / "bad.xyz";
  std::ofstream(file) << "one two\n";
  const std::string message = s.refusal("import \"" + file + "\"");
  EXPECT_TRUE(message.starts_with(file + ": ")) << message;
  EXPECT_NE(message.find("a point is no number"), std::string::npos) << message;
}

TEST(PluginHierarchy, EveryTypeInItCanBeHiddenAndKeepsAnAttributeOfThatNameOfItsOwn) {
  ListSession s;
  s.run("createNode place\ncreateNode ghost");
  EXPECT_EQ(s.run("getAttr place1.visibility\nsetAttr place1.visibility off\ngetAttr place1.visibility"),
            "true\nfalse");
  EXPECT_EQ(s.run("getAttr ghost1.out\nsetAttr ghost1.visibility 2\ngetAttr ghost1.out"), "0.5\n4");
  EXPECT_EQ(s.session.types().get("ghost")->schema()->find("visibility"), 0);
}

}  // namespace
}  // namespace plinian::sdk
