// Undo outlives plug-ins that go and come back.
#include <dlfcn.h>

#include <chrono>
#include <filesystem>
#include <random>
#include <set>

#include "host/graph/files/scene_writer.h"
#include "host/sdk/plugin_manager.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/sdk/plugin_session.h"

namespace plinian::sdk {
namespace {

using graph::message_of;

std::string scene_of(PluginSession& s) {
  return write_scene(s.session.graph());
}

TEST(UnloadHistory, AReloadedPluginFindsItsStepsOfUndoAsTheyWere) {
  PluginSession s;
  s.run(
      "loadPlugin wobble\ncreateNode wobble -name w\nsetAttr w.amount 4\ncreateNode wobbleTotal -name t\n"
      "connectAttr w.numbers t.source");
  const auto steps = s.session.history().undo_names();
  const std::string before = scene_of(s);
  s.run("unloadPlugin -force wobble\nloadPlugin wobble");
  EXPECT_EQ(s.session.history().undo_names(), steps);
  EXPECT_EQ(scene_of(s), before);
  EXPECT_EQ(s.run("undo 2\nundo\ngetAttr w.out"),
            "connectAttr w.numbers t.source\ncreateNode -name t wobbleTotal\nsetAttr w.amount 4\n2");
  EXPECT_EQ(s.run("redo 3\ngetAttr t.out").substr(0, 18), "setAttr w.amount 4");
  EXPECT_EQ(scene_of(s), before);
}

TEST(UnloadHistory, WhatWasDoneMeanwhileIsUndoneAndThenWhatWasBefore) {
  PluginSession s;
  s.run(
      "loadPlugin wobble\ncreateNode wobble -name w\nsetAttr w.amount 4\nunloadPlugin -force wobble\n"
      "rename w v\ncreateNode -name t transform");
  // Beyond the unloading one gets with the plug-in alone, and is told so.
  EXPECT_EQ(s.run("undo\nundo"), "createNode -name t transform\nrename w v");
  EXPECT_EQ(s.refusal("undo"),
            "'unloadPlugin wobble' brings back nodes of the type 'wobble': load the plug-in 'wobble' first");
  s.run("redo 2");
  std::vector<std::string> warnings;
  s.session.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  EXPECT_EQ(s.run("undo 9"), "createNode -name t transform\nrename w v") << "as far as it goes";
  EXPECT_EQ(warnings.size(), 1u);
  EXPECT_EQ(s.run("redo\nredo"), "rename w v\ncreateNode -name t transform");
  s.run("loadPlugin wobble");
  EXPECT_EQ(s.run("getAttr v.out"), "8");
  EXPECT_EQ(s.run("undo 4\ngetAttr w.out\nundo\ngetAttr w.out"),
            "loadPlugin wobble\ncreateNode -name t transform\nrename w v\nunloadPlugin wobble\n8\n"
            "setAttr w.amount 4\n2");
  EXPECT_EQ(s.run("redo 5\ngetAttr v.out"),
            "setAttr w.amount 4\nunloadPlugin wobble\nrename w v\ncreateNode -name t transform\n"
            "loadPlugin wobble\n8");
}

TEST(UnloadHistory, ADeletedNodeComesBackWithItsPluginAlone) {
  PluginSession s;
  s.run("loadPlugin wobble\ncreateNode wobble -name w\nsetAttr w.amount 4\ndelete w\nunloadPlugin wobble");
  EXPECT_EQ(s.refusal("undo"),
            "'delete w' brings back nodes of the type 'wobble': load the plug-in 'wobble' first");
  EXPECT_EQ(s.run("loadPlugin wobble\nundo\ngetAttr w.out"), "wobble\ndelete w\n8");
}

TEST(UnloadHistory, NeitherUnloadingNorLoadingModifiesTheScene) {
  PluginSession s;
  s.run("loadPlugin wobble\ncreateNode wobble -name w");
  s.session.history().mark_saved();
  s.run("unloadPlugin -force wobble");
  EXPECT_FALSE(s.session.history().is_modified());
  s.run("createNode transform");
  EXPECT_TRUE(s.session.history().is_modified());
  s.run("loadPlugin wobble\nundo 2");
  EXPECT_FALSE(s.session.history().is_modified());
}

TEST(UnloadHistory, NodesThatUndoMadeUnknownComeAliveByLoadingOnceMore) {
  PluginSession s;
  s.run(
      "loadPlugin wobble\ncreateNode wobble -name w\nunloadPlugin -force wobble\ncreateNode transform\n"
      "loadPlugin wobble\nundo");
  EXPECT_TRUE(s.session.graph().find("w")->type->is_unknown());
  EXPECT_EQ(s.run("loadPlugin wobble\ngetAttr w.out"), "wobble\n2");
  EXPECT_EQ(s.run("loadPlugin wobble\ngetAttr w.out"), "wobble\n2") << "and that is all there is to do";
}

TEST(UnloadHistory, StepsThatSpeakOfOtherAttributesAreForgottenAloud) {
  PluginSession s;
  std::vector<std::string> warnings;
  s.session.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  s.run(
      "loadPlugin wobble\ncreateNode wobble -name w\nsetAttr w.amount 4\nunloadPlugin -force wobble\n"
      "createNode transform");
  s.run("loadPlugin " PLINIAN_TEST_PLUGINS "/wobble_changed.so");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "3 steps of undo cannot be had any more: the plug-in 'wobble' does not declare what it did when "
            "they were made");
  EXPECT_EQ(s.run("getAttr w.amount\ngetAttr w.first"), "4\n0");
  EXPECT_EQ(s.run("undo 9"), "loadPlugin wobble\ncreateNode transform");
}

TEST(UnloadHistory, DataInStepsLetGoOfTheLibraryAndAreReadAgain) {
  PluginSession s;
  const std::string library = PLINIAN_TEST_PLUGINS "/extras.so";
  const auto is_mapped = [&] {
    void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_NOLOAD);
    if (handle) ::dlclose(handle);
    return handle != nullptr;
  };
  s.run(
      "loadPlugin extras\ncreateNode points -name p\nsetAttr p.points \"1 2\"\nsetAttr p.points \"3 4 5\"\n"
      "getAttr p.count");
  EXPECT_TRUE(is_mapped());
  s.run("unloadPlugin -force extras");
  EXPECT_FALSE(is_mapped());
  EXPECT_EQ(s.run("loadPlugin extras\nundo\ngetAttr p.points\ngetAttr p.count\nredo\ngetAttr p.points"),
            "extras\nsetAttr p.points \"3 4 5\"\n\"1 2\"\n2\nsetAttr p.points \"3 4 5\"\n\"3 4 5\"");
}

TEST(UnloadHistory, ALibraryThatCouldNotLeaveMemoryIsToldOfWhenItsFileHasChanged) {
  const TemporaryFolder own;
  const std::string library = own / "wobble.so";
  std::filesystem::copy_file(PLINIAN_TEST_PLUGINS "/wobble.so", library);
  PluginSession s;
  std::vector<std::string> warnings;
  s.session.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  s.run("loadPlugin \"" + library + "\"\ncreateNode wobble -name w");
  const graph::ResultPtr held = s.session.evaluator().evaluate(s.session.graph().plug("w.numbers"));
  const auto again = [&] { s.run("unloadPlugin -force wobble\nloadPlugin \"" + library + "\""); };
  again();
  EXPECT_TRUE(warnings.empty());
  std::filesystem::last_write_time(library,
                                   std::filesystem::last_write_time(library) + std::chrono::hours(1));
  again();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].find(library + ": has changed, but something still holds data"), 0u) << warnings[0];
}

TEST(UnloadHistory, DataThatCannotBeWrittenTakeTheirStepsWithThemAloud) {
  PluginSession s;
  std::vector<std::string> warnings;
  s.session.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  s.run(
      "loadPlugin extras\ncreateNode points -name p\nsetAttr p.blob \"bad\"\nsetAttr p.blob \"good\"\n"
      "createNode transform\nunloadPlugin -force extras\nloadPlugin extras");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "3 steps of undo cannot be had any more: they hold data of the plug-in 'extras' that cannot be "
            "written");
  EXPECT_EQ(s.run("getAttr p.blob"), "\"good\"");
  EXPECT_EQ(s.run("undo 9"), "createNode transform");
}

// Steps that have nothing to do with the plug-in stay, from before it went, too.
TEST(UnloadHistory, StepsThatTouchNothingOfTheForgottenOnesAreStillUndone) {
  PluginSession s;
  std::vector<std::string> warnings;
  s.session.on_warning = [&](const std::string& line) { warnings.push_back(line); };
  s.run(
      "createNode transform -name a\ncreateNode transform -name b\nsetAttr a.translate.x 3\nloadPlugin "
      "wobble\n"
      "createNode wobble -name w\nrename b c\nsetAttr w.amount 4\nconnectAttr w.out a.translate.y\n"
      "createNode transform -name b\nsetAttr c.translate.x 7\ncreateNode transform -name d -parent c\n"
      "unloadPlugin -force wobble\nsetAttr c.translate.y 8\n"
      "loadPlugin " PLINIAN_TEST_PLUGINS "/wobble_changed.so");
  // The node that the plug-in's drives is touched by that, and so are the steps that made it.
  EXPECT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings.at(0).find("6 steps of undo cannot be had any more"), 0u) << warnings.at(0);
  const std::string last = scene_of(s);
  EXPECT_EQ(s.run("undo 99"),
            "loadPlugin wobble\nsetAttr c.translate.y 8\ncreateNode -name d -parent c transform\n"
            "setAttr c.translate.x 7\ncreateNode -name b transform\nrename b c\n"
            "createNode -name b transform");
  EXPECT_EQ(s.run("ls"), "time1\na\nw");
  EXPECT_TRUE(s.session.history().is_modified());
  s.run("redo 99");
  EXPECT_EQ(scene_of(s), last);
}

// Nothing refers to what is not there, whatever was forgotten.
void expect_whole(const graph::Graph& graph) {
  std::set<std::string> names;
  for (const graph::Node* node : graph.nodes()) {
    EXPECT_TRUE(names.insert(node->name).second) << node->name;
    EXPECT_EQ(graph.find(node->name), node);
    EXPECT_TRUE(!node->parent || graph.find(node->parent)) << node->name;
    for (const graph::Input& input : node->inputs) {
      const graph::Plug end{node->id, input.attribute, input.element, input.component};
      EXPECT_TRUE(graph.find(input.source.node)) << node->name;
      EXPECT_TRUE(graph.outgoing(input.source.node).contains({input.source, end})) << node->name;
    }
    std::size_t above = 0;
    for (graph::NodeId at = node->parent; at && above <= graph.size(); at = graph.find(at)->parent) ++above;
    EXPECT_LE(above, graph.size()) << node->name << " is under itself";
  }
  for (const graph::NodeId id : graph.selection()) EXPECT_TRUE(graph.find(id));
}

// Whatever is done, with the plug-in coming and going, all of it can be undone and done again.
TEST(UnloadHistory, RandomCommandsAreUndoneToTheStartAcrossUnloading) {
  std::mt19937 random(7);
  const auto pick = [&](int count) { return int(random() % unsigned(count)); };
  std::size_t kept = 0;
  for (int round = 0; round < 16; ++round) {
    PluginSession s;
    bool loaded = false;
    const bool changes = round % 2;  // in the end another build of the plug-in is loaded
    const std::string first = scene_of(s);
    const auto any = [&] {
      const auto nodes = s.session.graph().nodes();
      return nodes.empty() ? std::string("none") : nodes[std::size_t(pick(int(nodes.size())))]->name;
    };
    int done = 0;
    for (int i = 0; i < 400; ++i) {
      std::string line;
      switch (pick(14)) {
        case 0:
          line = "createNode wobble";
          break;
        case 1:
          line = "createNode wobbleTotal";
          break;
        case 2:
          line = "createNode transform";
          break;
        case 3:
          line = "setAttr " + any() + ".amount " + std::to_string(pick(9));
          break;
        case 4:
          line = "connectAttr " + any() + ".numbers " + any() + ".source";
          break;
        case 5:
          line = "connectAttr " + any() + ".out " + any() + ".translate.x";
          break;
        case 6:
          line = "rename " + any() + " n" + std::to_string(pick(30));
          break;
        case 7:
          line = "delete " + any();
          break;
        case 8:
          line = "setAttr " + any() + ".more[" + std::to_string(pick(3)) + "] 2";
          break;
        case 9:
          line = pick(2) ? "undo" : "redo";
          break;
        case 10:
          line = "addAttr " + any() + " extra";
          break;
        case 11:
          line = "parent " + any() + " " + any();
          break;
        case 12:
          line = "select " + any() + " " + any();
          break;
        default:
          if (pick(3)) continue;
          line = loaded ? "unloadPlugin -force wobble" : "loadPlugin wobble";
          s.run(line);
          loaded = !loaded;
          continue;
      }
      try {
        s.session.execute(line);
        ++done;
      } catch (const graph::GraphError&) {
      }
    }
    EXPECT_GT(done, 100);
    if (changes) {
      if (loaded) s.run("unloadPlugin -force wobble");
      s.run("createNode transform\nloadPlugin " PLINIAN_TEST_PLUGINS "/wobble_changed.so");
    } else if (!loaded) {
      s.run("loadPlugin wobble");
    }
    const std::string last = scene_of(s);
    const std::size_t steps = s.session.history().undo_names().size();
    if (changes) kept += steps;
    for (std::size_t i = 0; i < steps; ++i) {
      s.session.history().undo();
      expect_whole(s.session.graph());
    }
    EXPECT_TRUE(changes || scene_of(s) == first) << scene_of(s);
    for (std::size_t i = 0; i < steps; ++i) s.session.history().redo();
    EXPECT_EQ(scene_of(s), last);
    expect_whole(s.session.graph());
  }
  EXPECT_GT(kept, 8u * 10u);
}

}  // namespace
}  // namespace plinian::sdk
