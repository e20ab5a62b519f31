// File types, menu entries and events of plug-ins.
#include <fstream>

#include "host/graph/files/scene_reader.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

struct ExtrasSession : PluginSession {
  std::vector<std::string> warnings;
  ExtrasSession() {
    session.on_warning = [this](const std::string& line) { warnings.push_back(line); };
    run("loadPlugin extras");
  }
};

TEST(FileType, ImportAndExportTakeFilesByTheirExtensionAsOneStepOfUndo) {
  const TemporaryFolder own;
  std::ofstream(own / "a.XYZ") << "1 2 3\n";
  ExtrasSession s;
  EXPECT_EQ(s.run("import -namespace lib \"" + own / "a.XYZ" + "\"\ngetAttr lib:read.count"), "lib:read\n3");
  EXPECT_EQ(s.run("export \"" + own / "b.pts" + "\" lib:read"), "");
  EXPECT_EQ(graph::read_text_file(own / "b.pts"), "\"1 2 3\"\n");
  s.run("undo 2\nls");
  EXPECT_EQ(s.run("ls"), "time1");
  EXPECT_EQ(s.refusal("import \"" + own / "none.xyz" + "\""),
            own / "none.xyz" + std::string(": cannot be read"));
  s.run("unloadPlugin extras");
  EXPECT_NE(s.refusal("import \"" + own / "a.XYZ" + "\""), "");
}

TEST(MenuEntry, IsListedWhileItsPluginIsLoaded) {
  ExtrasSession s;
  ASSERT_EQ(s.plugins.menu().size(), 1u);
  EXPECT_EQ(s.plugins.menu()[0].path, "Create/Points");
  EXPECT_EQ(s.plugins.menu()[0].command, "createNode points");
  s.run("unloadPlugin extras");
  EXPECT_TRUE(s.plugins.menu().empty());
}

TEST(Event, TellsWhatHappenedAfterEachCommand) {
  const TemporaryFolder own;
  ExtrasSession s;
  s.run("heard");
  const auto heard = [&](const std::string& lines) {
    s.run(lines);
    return s.run("heard");
  };
  EXPECT_EQ(heard("createNode points -name a"), "nodeCreated a\nonce a\nselectionChanged");
  EXPECT_EQ(heard("createNode points -name b"), "nodeCreated b\nselectionChanged");  // once and no more
  EXPECT_EQ(heard("rename b c"), "nodeRenamed c (b)");
  EXPECT_EQ(heard("setAttr a.points \"1\""), "attributeChanged a.points");
  EXPECT_EQ(heard("setAttr a.points \"1\""), "");
  EXPECT_EQ(heard("undo"), "attributeChanged a.points");
  EXPECT_EQ(heard("createNode animCurve -name k\nconnectAttr time1.out k.in -force\ndisconnectAttr k.in"),
            "nodeCreated k\nselectionChanged\nconnected k.in (time1.out)\ndisconnected k.in");
  EXPECT_EQ(heard("currentTime 5"), "timeChanged 5");
  EXPECT_EQ(heard("select a"), "selectionChanged");
  EXPECT_EQ(heard("save \"" + own / "s.plinian" + "\""), "beforeSave (s.plinian)\nafterSave (s.plinian)");
  EXPECT_EQ(heard("newScene"), "beforeNew\nafterNew\ntimeChanged 1");
  EXPECT_EQ(heard("open \"" + own / "s.plinian" + "\""), "beforeOpen (s.plinian)\nafterOpen (s.plinian)");
  EXPECT_EQ(heard("delete c"), "nodeDeleted c");
  EXPECT_TRUE(s.warnings.empty());
}

TEST(Event, WhatAFailedCommandTookBackIsNotTold) {
  ExtrasSession s;
  s.run("createNode points -name p\nheard");
  EXPECT_NE(s.refusal("import /none.xyz"), "");
  EXPECT_NE(s.refusal("duplicate p nobody"), "");
  EXPECT_EQ(s.run("heard"), "");
}

TEST(Event, ACallbackMayEditAndItsEditsAreToldTooAndBelongToTheSameStep) {
  ExtrasSession s;
  s.run("createNode points -name lead\ncreateNode points -name follow\nheard\nsetAttr lead.points \"1\"");
  EXPECT_EQ(s.run("getAttr follow.count\nheard"),
            "4\nattributeChanged lead.points\nattributeChanged follow.points");
  // The callback is told of the undo, too, but has no say in it.
  const std::string call = "setAttr lead.points \"1\"";
  EXPECT_EQ(s.run("undo\ngetAttr follow.count\ngetAttr lead.count"), call + "\n-1\n-1");
  EXPECT_EQ(s.run("redo\ngetAttr follow.count\ngetAttr lead.count"), call + "\n4\n1");
  EXPECT_EQ(s.run("undo\nundo"), call + "\ncreateNode -name follow points");
  EXPECT_TRUE(s.warnings.empty());
}

TEST(Event, OneThatThrowsIsToldOnceAndDisturbsNobody) {
  ExtrasSession s;
  s.run("createNode points -name bad\nheard\nsetAttr bad.blob \"1\"\nsetAttr bad.blob \"2\"");
  EXPECT_EQ(s.run("heard"), "attributeChanged bad.blob\nattributeChanged bad.blob");
  EXPECT_EQ(s.warnings, std::vector<std::string>{
                            "the plug-in 'extras': its callback for attributeChanged failed: not that one"});
}

TEST(Event, NeverComesInTheMiddleOfAnEditNorDuringAComputation) {
  ExtrasSession s;
  s.run("createNode points -name p");
  int inside = 0, told = 0;
  const auto subscription =
      s.plugins.events().subscribe(EventKind::attribute_changed, "test", [&](const SceneEvent&) {
        inside += s.session.history().is_open();
        ++told;
      });
  {
    const graph::History::Scope scope(s.session.history(), "drag");
    s.run("setAttr p.points \"1\"");
    s.plugins.events().deliver();
    EXPECT_EQ(told, 0);
  }
  s.plugins.events().deliver();
  EXPECT_EQ(told, 1);
  EXPECT_EQ(inside, 0);
}

TEST(Event, EndsWithItsSubscriptionAndWithItsPlugin) {
  ExtrasSession s;
  int told = 0;
  {
    const auto subscription =
        s.plugins.events().subscribe(EventKind::node_created, "test", [&](const SceneEvent&) { ++told; });
    s.run("createNode points");
  }
  s.run("createNode points\ndelete points*\nunloadPlugin extras\ncurrentTime 9");
  EXPECT_EQ(told, 1);
  EXPECT_TRUE(s.warnings.empty());
  EventHub::Subscription longer;
  {
    ExtrasSession other;
    longer = other.plugins.events().subscribe(EventKind::node_created, "test", [](const SceneEvent&) {});
  }
  longer.end();
}

TEST(Event, CallbacksThatCallEachOtherEndlesslyAreStopped) {
  ExtrasSession s;
  s.run("createNode points -name p");
  int told = 0;
  const auto subscription = s.plugins.events().subscribe(
      EventKind::attribute_changed, "test",
      [&](const SceneEvent&) { s.session.execute("setAttr p.points \"" + std::to_string(++told) + "\""); });
  s.run("setAttr p.points \"0\"");
  EXPECT_LE(told, 200);
  ASSERT_FALSE(s.warnings.empty());
  EXPECT_EQ(s.warnings.back(), "event callbacks cause events without end; the rest is not told");
}

TEST(Event, AnUnknownKindAndUnloadingFromWithinAreRefused) {
  ExtrasSession s;
  EXPECT_EQ(graph::message_of([] { event_of_name("nodeCreate"); }),
            "there is no event 'nodeCreate' (did you mean 'nodeCreated'?)");
  std::string message;
  const auto subscription =
      s.plugins.events().subscribe(EventKind::time_changed, "test", [&](const SceneEvent&) {
        message = graph::message_of([&] { s.session.execute("unloadPlugin extras"); });
      });
  s.run("currentTime 3");
  EXPECT_EQ(message, "the plug-in 'extras' cannot be unloaded by an event callback");
}

}  // namespace
}  // namespace plinian::sdk
