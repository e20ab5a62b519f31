#include "host/sdk/plugin_manager.h"

#include <fstream>

#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

using graph::message_of;
const std::string folder = PLINIAN_TEST_PLUGINS;

TEST(PluginManager, LoadsByNameAndRunsWhatItBrings) {
  PluginSession s;
  EXPECT_EQ(s.run("loadPlugin wobble"), "wobble");
  EXPECT_EQ(s.run("createNode wobble -name w\nsetAttr w.amount 4\ngetAttr w.out"), "w\n8");
  EXPECT_EQ(s.run("setAttr w.more[3] 1.5\nsetAttr w.offset.y 0.25\ngetAttr w.out"), "9.75");
  EXPECT_EQ(s.run("setAttr w.mode off\ngetAttr w.out\nsetAttr w.mode on\ngetAttr w.label"),
            "0\n\"two words\"");
  EXPECT_EQ(s.run("setAttr w.strength 5\ngetAttr w.amount"), "5");  // by the name it had before
  EXPECT_EQ(s.run("createNode wobbleTotal -name t\nconnectAttr w.numbers t.source\ngetAttr t.out"), "t\n10");
  s.run("setAttr w.label fail");
  EXPECT_EQ(message_of([&] { s.session.execute("getAttr w.out"); }), "w.out: the label says so");
  EXPECT_NE(s.run("pluginInfo")
                .find("wobble 1.2, A. Artist, interface 1.3, registers node:wobble node:wobbleTotal "
                      "command:wobbleAll, "),
            std::string::npos);
}

TEST(PluginManager, ItsCommandsAreOneStepOfUndo) {
  PluginSession s;
  s.run("loadPlugin wobble\ncreateNode wobble -name a\ncreateNode wobble -name b");
  EXPECT_EQ(s.run("wobbleAll 7 a b\ngetAttr a.amount\ngetAttr b.amount"), "done\n7\n7");
  EXPECT_EQ(s.run("undo\ngetAttr a.amount\ngetAttr b.amount"), "wobbleAll 7 a b\n1\n1");
  // What fails halfway is taken back, and says why in the words of the command that failed.
  EXPECT_EQ(message_of([&] { s.session.execute("wobbleAll 9 a nobody"); }),
            "wobbleAll: there is no node 'nobody'");
  EXPECT_EQ(s.run("getAttr a.amount"), "1");
  EXPECT_EQ(message_of([&] { s.session.execute("wobbleAll much a"); }),
            "wobbleAll: AMOUNT expects a number, not 'much'");
}

TEST(PluginManager, AnInputIsReadAtAnotherTimeAcrossTheBoundary) {
  PluginSession s;
  s.run(
      "loadPlugin wobble\ncreateNode wobble -name w\nconnectAttr time1.out w.when\n"
      "setKeyframe w.in -time 0 -value 0 -interpolation linear\nsetKeyframe w.in -time 10 -value 100\n"
      "currentTime 6");
  EXPECT_EQ(s.run("getAttr w.in\ngetAttr w.before"), "60\n50");
}

TEST(PluginManager, BuiltWithTheOtherStringsItWorksAllTheSame) {
  PluginSession s;
  EXPECT_EQ(s.run("loadPlugin old_strings\ncreateNode oldWobble -name w\nsetAttr w.amount 3\ngetAttr w.out"),
            "oldStrings\nw\n6");
  EXPECT_EQ(s.run("loadPlugin wobble\ncreateNode wobble\ngetAttr wobble1.out"), "wobble\nwobble1\n2");
}

TEST(PluginManager, BuiltWithAnOlderVersionOfTheInterfaceItWorksAllTheSame) {
  PluginSession s;
  EXPECT_EQ(s.run("loadPlugin older\ncreateNode olderWobble -name w\nwobbleAll 3 w\ngetAttr w.out"),
            "older\nw\ndone\n6");
  EXPECT_NE(s.run("pluginInfo older").find("interface 1.0"), std::string::npos);
  EXPECT_EQ(s.run("connectAttr time1.out w.when\nsetKeyframe w.in -time 0 -value 0 -interpolation linear\n"
                  "setKeyframe w.in -time 10 -value 100\ncurrentTime 6\ngetAttr w.before"),
            "w_in\nw_in\n6\n50");
  s.run("unloadPlugin -force older");
  EXPECT_TRUE(s.session.graph().find("w")->type->is_unknown());
}

TEST(PluginManager, OlderScenesAreMigratedByIt) {
  const TemporaryFolder own;
  std::ofstream(own / "old.pln") << "plinian scene 1.0\nrequires wobble 1.0\nnode wobble w\n  .half 4\n"
                                    "type wobble 1 from wobble 1.0\n  .half 0.5\nend\n";
  PluginSession s;
  s.run("loadPlugin wobble\nopen \"" + own / "old.pln" + "\"");
  EXPECT_EQ(s.run("getAttr w.amount"), "8");
}

TEST(PluginManager, ASceneBringsTheInstalledPluginsThatItNeedsAndNoOthers) {
  const TemporaryFolder own;
  PluginSession s;
  s.run("loadPlugin wobble\ncreateNode wobble -name w\nsave \"" + own / "a.plinian" + "\"");
  PluginSession other;
  other.run("open \"" + own / "a.plinian" + "\"");
  EXPECT_EQ(other.run("getAttr w.out"), "2");
  std::filesystem::copy_file(folder + "/wobble.so", own / "wobble.so");
  std::ofstream(own / "evil.pln") << "plinian scene 1.0\nrequires " + own / "wobble.so" +
                                         " 1\nrequires none 1\nend\n";
  PluginSession third;
  std::vector<std::string> warnings;
  third.session.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  third.run("open \"" + own / "evil.pln" + "\"");
  EXPECT_EQ(third.plugins.plugins().size(), 1u);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0], "the scene needs a plug-in '" + own / "wobble.so" + "'");
  EXPECT_EQ(warnings[1], "there is no plug-in 'none' in " + folder);
}

TEST(PluginManager, AnOlderVersionThanASceneNeedsIsToldOfLikeANewerFormat) {
  const TemporaryFolder own;
  const auto opened = [&](const std::string& version) {
    const std::string path =
        own.write("a.pln", "plinian scene 1.0\nrequires wobble " + version + "\nnode wobble w\nend\n");
    PluginSession s;
    std::string warnings;
    s.session.on_warning = [&](const std::string& line) { warnings += line + "\n"; };
    s.run("open \"" + path + "\"");
    EXPECT_EQ(s.session.is_read_only(), !version.starts_with("1."));
    return warnings;
  };
  const std::string here = own / "a.pln" + ": was saved with version ";
  EXPECT_EQ(opened("1.2"), "");
  EXPECT_EQ(opened("1.1.9"), "");
  EXPECT_EQ(opened("1.10"), here +
                                "1.10 of the plug-in 'wobble', here is 1.2: what is not known here is kept "
                                "as it is\n");
  EXPECT_EQ(opened("9.0"), here + "9.0 of the plug-in 'wobble', here is 1.2: it is opened read-only\n");
}

TEST(PluginManager, WhatIsNotLoadedIsToldOfByWhoeverBringsIt) {
  PluginSession s;
  EXPECT_EQ(message_of([&] { s.session.execute("createNode points"); }),
            "unknown node type 'points': the plug-in 'extras' brings it: loadPlugin extras");
  EXPECT_EQ(message_of([&] { s.session.execute("heard"); }),
            "unknown command 'heard': the plug-in 'extras' brings it: loadPlugin extras");
  EXPECT_EQ(message_of([&] { s.session.execute("createNode pints"); }),
            "unknown node type 'pints' (did you mean 'points': the plug-in 'extras' brings it: loadPlugin "
            "extras)");
  EXPECT_EQ(message_of([&] { s.session.execute("createNode nosuch"); })
                .find("unknown node type 'nosuch'; "
                      "there are: ambientLight, "),
            0u);
  s.run("loadPlugin extras\ncreateNode points\nheard");
  EXPECT_EQ(message_of([&] { s.session.execute("createNode pints"); }),
            "unknown node type 'pints' (did you mean 'points'?)");
}

TEST(PluginManager, ACurrentFolderIsNoSearchPath) {
  const TemporaryFolder own;
  std::filesystem::copy_file(folder + "/wobble.so", own / "wobble.so");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(own.path());
  ::setenv("PLINIAN_PLUGIN_PATH", ":.:", 1);
  graph::Session session;
  PluginManager plugins(session, {});
  EXPECT_EQ(message_of([&] { plugins.load("wobble"); }),
            "there is no plug-in 'wobble' in any folder: set PLINIAN_PLUGIN_PATH, or give a path");
  ::setenv("PLINIAN_PLUGIN_PATH", own.path().c_str(), 1);
  PluginSession other;
  EXPECT_EQ(other.plugins.search().folders().at(0), own.path());
  EXPECT_EQ(other.plugins.load("wobble"), "wobble");
  ::unsetenv("PLINIAN_PLUGIN_PATH");
  std::filesystem::current_path(before);
}

TEST(PluginManager, UnloadingIsRefusedWhileNodesExistOrKeepsThemWhole) {
  PluginSession s;
  s.run(
      "loadPlugin wobble\ncreateNode wobble -name w\ncreateNode wobbleTotal -name t\nconnectAttr w.numbers "
      "t.source\n"
      "setAttr w.amount 4\ngetAttr t.out");
  EXPECT_EQ(
      s.refusal("unloadPlugin wobble"),
      "the plug-in 'wobble' is in use by w, t: delete them, or give -force to keep them as unknown nodes");
  const std::string before = write_scene(s.session.graph());
  s.run("unloadPlugin -force wobble");
  EXPECT_TRUE(s.session.graph().find("w")->type->is_unknown());
  EXPECT_EQ(write_scene(s.session.graph()), before);
  EXPECT_EQ(message_of([&] { s.session.execute("createNode wobble"); }).find("unknown node type 'wobble'"),
            0u);
  s.run("loadPlugin wobble");
  EXPECT_EQ(s.run("getAttr t.out"), "9");
  EXPECT_EQ(write_scene(s.session.graph()), before);
  EXPECT_EQ(s.run("delete w t\nunloadPlugin wobble\npluginInfo").find("wobble"), std::string::npos);
}

TEST(PluginManager, UnloadingEndsWhatIsRunning) {
  PluginSession s;
  s.run("loadPlugin wobble\ncreateNode wobble -name w");
  for (int i = 0; i < 50; ++i) {
    s.run("setAttr w.amount " + std::to_string(i));
    s.session.evaluator().request({s.session.graph().plug("w.numbers")}, nullptr);
  }
  s.run("unloadPlugin -force wobble");
}

}  // namespace
}  // namespace plinian::sdk
