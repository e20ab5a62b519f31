// Data of plug-ins in scene files.
#include <fstream>

#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

TEST(DataType, IsSetStoredAndReadAgainAsTextOrBase64) {
  const TemporaryFolder own;
  PluginSession s;
  s.run(
      "loadPlugin extras\ncreateNode points -name p\nsetAttr p.points \"1 2.5 3\"\n"
      "setAttr p.blob base64:AP/+gICA");
  EXPECT_EQ(s.run("getAttr p.count\ngetAttr p.points\ngetAttr p.blob"), "9\n\"1 2.5 3\"\nbase64:AP/+gICA");
  const std::string text = write_scene(s.session.graph());
  EXPECT_NE(text.find("  .points \"1 2.5 3\"\n  .blob base64:AP/+gICA\n"), std::string::npos) << text;
  s.run("save \"" + own / "a.plinian" + "\"");
  PluginSession other;
  other.run("open \"" + own / "a.plinian" + "\"");  // which loads the plug-in
  EXPECT_EQ(other.run("getAttr p.count"), "9");
  EXPECT_EQ(write_scene(other.session.graph()), text);
}

TEST(DataType, SettingEqualDataDirtiesNothingAndUndoBringsTheOldBack) {
  PluginSession s;
  s.run("loadPlugin extras\ncreateNode points -name p\nsetAttr p.points \"1 2\"\ngetAttr p.count");
  const std::uint64_t before = s.session.graph().generation();
  s.run("setAttr p.points \"1 2\"");
  EXPECT_EQ(s.session.graph().generation(), before);
  EXPECT_EQ(s.run("setAttr p.points \"7\"\ngetAttr p.count\nundo\ngetAttr p.count\nresetAttr p.points\n"
                  "getAttr p.count"),
            "1\nsetAttr p.points \"7\"\n2\n-1");
}

TEST(DataType, BytesThatAreNoneCostALine) {
  PluginSession s;
  s.run("loadPlugin extras\ncreateNode points -name p");
  EXPECT_EQ(s.refusal("setAttr p.points \"1 two\""),
            "p.points holds data of type 'pointList' that cannot be read: a point is no number");
  EXPECT_EQ(s.refusal("setAttr p.blob base64:AP/"), "p.blob holds base64 that was cut");
  EXPECT_EQ(s.refusal("setAttr p.blob base64:AP_="), "p.blob holds what is no base64");
  EXPECT_EQ(s.refusal("setAttr p.blob 12"),
            "p.blob expects data of type 'blob' in quotes or as base64, not '12'");
  s.run("setAttr p.blob \"bad\"");
  EXPECT_EQ(s.refusal("getAttr p.blob"), "data of type 'blob' cannot be written: it is spoiled");
  EXPECT_EQ(s.refusal("unloadPlugin -force extras"),
            "the plug-in 'extras' cannot be unloaded: data of type 'blob' cannot be written: it is spoiled");
}

TEST(DataType, WithoutItsPluginTheLinesAreKeptAndComeAliveAgain) {
  const TemporaryFolder own;
  PluginSession s;
  s.run("loadPlugin extras\ncreateNode points -name p\nsetAttr p.points \"1 2\"");
  const std::string text = write_scene(s.session.graph());
  s.run("unloadPlugin -force extras");
  EXPECT_EQ(write_scene(s.session.graph()), text);
  s.run("loadPlugin extras");
  EXPECT_EQ(write_scene(s.session.graph()), text);
  EXPECT_EQ(s.run("getAttr p.count"), "2");
}

// The node is the program's own, and only its data's type goes and comes.
TEST(DataType, NodesOfOthersKeepWhatTheyHoldAsLinesWhileTheTypeIsGone) {
  PluginSession s;
  s.session.types().add(
      {.name = "holder",
       .attributes = {{.name = "points", .type = graph::AttributeType::data, .data_type = "pointList"}}});
  s.run("loadPlugin extras\ncreateNode holder -name h\nsetAttr h.points \"4 5\"");
  const std::string text = write_scene(s.session.graph());
  s.run("unloadPlugin extras");
  EXPECT_EQ(write_scene(s.session.graph()), text);
  EXPECT_EQ(graph::message_of([&] { s.run("setAttr h.points \"1\""); }),
            "script:1: h.points holds data of type 'pointList', which have no text form here");
  s.run("loadPlugin extras");
  EXPECT_EQ(s.run("getAttr h.points"), "\"4 5\"");
  EXPECT_EQ(write_scene(s.session.graph()), text);
}

}  // namespace
}  // namespace plinian::sdk
