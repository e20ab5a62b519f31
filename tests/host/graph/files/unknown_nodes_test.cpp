// A scene outlives the plug-ins that it was made with.
#include "host/graph/files/unknown_nodes.h"

#include <fstream>
#include <random>

#include "host/graph/edits/clear.h"
#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
#include "tests/core/scene/temporary_folder.h"
#include "tests/host/graph/commands/test_session.h"
#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

NodeTypeSpec plume() {
  return {.name = "plume",
          .version = 2,
          .attributes = {{.name = "density", .default_value = 3.0, .affects = {"out"}},
                         {.name = "target", .type = AttributeType::node},
                         {.name = "keys", .array = true},
                         {.name = "out", .output = true}},
          .compute = [](ComputeContext&, AttributeIndex) {},
          .hierarchical = true,
          .plugin = "ashworks",
          .plugin_version = "1.2"};
}

std::string scene_with_plume() {
  TestScene scene;
  scene.registry.add(plume());
  const NodeId top = scene.create("group", "top");
  scene.create("plume", "p", top);
  scene.create("plume", "q");
  scene.create("sum", "s");
  scene.set("p.density", 4.0);
  scene.set("p.keys[3]", 0.0);
  scene.set("p.target", top);
  scene.connect("s.out", "q.density");
  scene.connect("p.out", "q.keys[1]");
  scene.connect("q.out", "top.translate.x");
  scene.editor.add_attribute(scene.graph.find("p")->id, {.name = "note", .type = AttributeType::string});
  scene.set("p.note", std::string("left  bank"));
  scene.editor.lock(scene.plug("p.density"), true);
  return write_scene(scene.graph);
}

TEST(UnknownNodes, ASceneWithoutItsPluginKeepsEveryLine) {
  const std::string text = scene_with_plume();
  EXPECT_NE(text.find("requires ashworks 1.2\n"), std::string::npos);
  TestScene scene;
  const SceneReport report = read_scene(text, "a.pln", scene.registry, scene.editor);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_EQ(report.warnings[0],
            "a.pln: the node type 'plume' is not known: it needs the plug-in ashworks; 2 nodes are kept as "
            "they are");
  EXPECT_EQ(write_scene(scene.graph), text);
  EXPECT_EQ(message_of([&] { scene.plug("p.density"); }),
            "node 'p' (plume) has no attribute 'density': its type is not known here; the plug-in 'ashworks' "
            "brings it: loadPlugin ashworks");
}

// A scene that takes another one's place needs none of its plug-ins.
TEST(UnknownNodes, WhatIsClearedIsNotRememberedAndComesBackInOneStep) {
  const std::string text = scene_with_plume();
  TestScene scene;
  read_scene(text, "a.pln", scene.registry, scene.editor);
  {
    const History::Scope scope(scene.history, "clear");
    clear_graph(scene.editor);
  }
  EXPECT_EQ(write_scene(scene.graph), write_scene(TestScene().graph));
  scene.history.undo();
  EXPECT_EQ(write_scene(scene.graph), text);
}

TEST(UnknownNodes, TheyFollowNewNamesAndLoseConnectionsToWhatIsDeleted) {
  TestScene scene;
  read_scene(scene_with_plume(), "a.pln", scene.registry, scene.editor);
  const std::string before = write_scene(scene.graph);
  scene.editor.rename(scene.graph.find("s")->id, "sum_of_all");
  scene.editor.rename(scene.graph.find("p")->id, "pp");
  EXPECT_NE(write_scene(scene.graph).find(".density <- sum_of_all.out\n  .keys[1] <- pp.out\n"),
            std::string::npos);
  scene.editor.delete_nodes({scene.graph.find("sum_of_all")->id});
  EXPECT_EQ(write_scene(scene.graph).find(".density <-"), std::string::npos);
  while (scene.graph.find("s") == nullptr) scene.history.undo();
  EXPECT_EQ(write_scene(scene.graph), before);
}

TEST(UnknownNodes, WhatTheyDriveIsSeenHeldAndLetGoOfAndCopiedWithThem) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.plinian") << scene_with_plume();
  TestSession s;
  s.run("open " + (folder / "a.plinian"));
  EXPECT_EQ(s.run("listConnections top.translate"), "q.out -> top.translate.x");
  EXPECT_EQ(s.run("listConnections q"), "s.out -> q.density\np.out -> q.keys[1]\nq.out -> top.translate.x");
  EXPECT_EQ(s.refusal("setAttr top.translate.x 3"),
            "top.translate.x is driven by q.out, of a type that is not known here: disconnect it first");
  EXPECT_EQ(
      s.refusal("getAttr top.translate.x"),
      "top.translate.x is driven by q.out, of a type that is not known here: its value is not known either");
  s.run("setAttr top.translate.y 3");
  s.run("duplicate top q s");
  EXPECT_EQ(s.run("listConnections top1"), "q1.out -> top1.translate.x");
  EXPECT_EQ(s.run("listConnections q1 -source"), "s1.out -> q1.density\np1.out -> q1.keys[1]");
  s.run("duplicate q");
  EXPECT_EQ(s.run("listConnections q2"), "s.out -> q2.density\np.out -> q2.keys[1]");
  s.run("disconnectAttr top.translate.x\nsetAttr top.translate.x 3");
  EXPECT_EQ(s.run("listConnections top"), "");
  s.run("undo 2");
  EXPECT_EQ(s.run("listConnections top"), "q.out -> top.translate.x");
  EXPECT_EQ(
      s.refusal("connectAttr s1.out top.translate.x"),
      "top.translate.x is already driven by q.out, of a type that is not known here: disconnect it first, "
      "or connect with -force");
}

TEST(UnknownNodes, TheyComeAliveWithTheirPlugin) {
  const std::string text = scene_with_plume();
  TestScene scene;
  read_scene(text, "a.pln", scene.registry, scene.editor);
  EXPECT_TRUE(revive_nodes(scene.editor, scene.registry.add(plume())).empty());
  EXPECT_EQ(write_scene(scene.graph), text);
  EXPECT_EQ(scene.value("p.density"), Value(4.0f));
  EXPECT_EQ(scene.value("p.note"), Value(std::string("left  bank")));
  EXPECT_EQ(scene.graph.find("top")->inputs.at(0).source.node, scene.graph.find("q")->id);
  EXPECT_EQ(message_of([&] { scene.set("p.density", 1.0); }), "p.density is locked");
  EXPECT_TRUE(scene.graph.kept_types().empty());
}

TEST(UnknownNodes, ForgettingATypeLosesNothing) {
  const std::string text = scene_with_plume();
  TestScene scene;
  const NodeTypePtr type = scene.registry.add(plume());
  read_scene(text, "a.pln", scene.registry, scene.editor);
  scene.registry.remove("plume");
  forget_type(scene.editor, type);
  EXPECT_TRUE(scene.graph.find("p")->type->is_unknown());
  EXPECT_EQ(write_scene(scene.graph), text);
  revive_nodes(scene.editor, scene.registry.add(plume()));
  EXPECT_EQ(write_scene(scene.graph), text);
}

TEST(UnknownNodes, AnOlderPluginKeepsWhatANewerOneWrote) {
  const std::string text = scene_with_plume();
  TestScene scene;
  NodeTypeSpec older = plume();
  older.version = 1;
  older.attributes.erase(older.attributes.begin() + 2);  // it had no keys
  scene.registry.add(older);
  read_scene(text, "a.pln", scene.registry, scene.editor);
  const std::string again = write_scene(scene.graph);
  for (const char* line :
       {"type plume 2 from ashworks 1.2\n", "  .keys[3] 0\n", "  .keys[1] <- p.out\n", "  .keys 0\n"})
    EXPECT_NE(again.find(line), std::string::npos) << line;
}

TEST(UnknownNodes, ImportingAnotherDefaultOfAnUnknownTypeSpellsItOut) {
  const auto text = [](const std::string& value) {
    return "plinian scene 1.0\nnode plume p\ntype plume 1\n  .density " + value + "\nend\n";
  };
  TestScene scene;
  read_scene(text("3"), "a.pln", scene.registry, scene.editor);
  read_scene(text("8"), "b.pln", scene.registry, scene.editor, "b");
  scene.registry.add(plume());
  revive_nodes(scene.editor, scene.registry.get("plume"));
  EXPECT_EQ(scene.value("p.density"), Value(3.0f));
  EXPECT_EQ(scene.value("b:p.density"), Value(8.0f));
}

// Without its plug-in a node may be put anywhere; with it, the type may have no place there.
std::string scene_with_plumes_anywhere() {
  TestScene scene;
  read_scene(scene_with_plume(), "a.pln", scene.registry, scene.editor);
  scene.create("shape", "leaf", scene.graph.find("p")->id);
  scene.editor.set_parent({scene.graph.find("q")->id}, scene.graph.find("leaf")->parent);
  return write_scene(scene.graph);
}

NodeTypeSpec flat_plume() {
  NodeTypeSpec flat = plume();
  flat.hierarchical = false;
  return flat;
}

const std::string no_place =
    "p (plume) has no place in the transform hierarchy: that p stands under top is kept in the scene and "
    "moves nothing";

TEST(UnknownNodes, ATypeWithoutAPlaceKeepsWhereTheSceneHasItsNodes) {
  const std::string text = scene_with_plumes_anywhere();
  ASSERT_NE(text.find("node shape leaf under p\n"), std::string::npos) << text;
  TestScene scene;
  scene.registry.add(flat_plume());
  const SceneReport report = read_scene(text, "a.pln", scene.registry, scene.editor);
  ASSERT_EQ(report.warnings.size(), 3u);
  EXPECT_EQ(report.warnings[0], "a.pln:5: " + no_place);
  EXPECT_NE(report.warnings[1].find("p (plume) cannot be a parent: that leaf stands under p is kept"),
            std::string::npos)
      << report.warnings[1];
  EXPECT_EQ(scene.value("p.density"), Value(4.0f)) << "it works all the same";
  EXPECT_FALSE(scene.graph.find("p")->parent);
  EXPECT_FALSE(scene.graph.find("leaf")->parent);
  EXPECT_EQ(write_scene(scene.graph), text);
  // Where it is put somewhere else, that is where it stands.
  scene.editor.set_parent({scene.graph.find("leaf")->id}, scene.graph.find("top")->id);
  scene.editor.set_parent({scene.graph.find("p")->id}, {});
  const std::string moved = write_scene(scene.graph);
  EXPECT_NE(moved.find("node shape leaf under top\n"), std::string::npos) << moved;
  EXPECT_NE(moved.find("node plume p\n"), std::string::npos) << moved;
  EXPECT_NE(moved.find("node plume q under p\n"), std::string::npos) << moved;
}

TEST(UnknownNodes, ATypeWithoutAPlaceThatComesAndGoesLosesNoPlaces) {
  const std::string text = scene_with_plumes_anywhere();
  TestScene scene;
  read_scene(text, "a.pln", scene.registry, scene.editor);
  const NodeTypePtr flat = scene.registry.add(flat_plume());
  const std::vector<std::string> warnings = revive_nodes(scene.editor, flat);
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_EQ(warnings[0], no_place);
  EXPECT_EQ(write_scene(scene.graph), text);
  scene.registry.remove("plume");
  forget_type(scene.editor, flat);
  EXPECT_EQ(scene.graph.find("leaf")->parent, scene.graph.find("p")->id);
  EXPECT_EQ(scene.graph.find("p")->parent, scene.graph.find("top")->id);
  EXPECT_EQ(write_scene(scene.graph), text);
  while (!scene.history.undo_names().empty()) scene.history.undo();
  EXPECT_EQ(scene.graph.size(), 0u);
}

// A scene as anybody may have made it with the plug-in.
std::string random_scene(std::mt19937& random) {
  TestScene scene;
  scene.registry.add(plume());
  const auto chance = [&](unsigned of) { return random() % of == 0; };
  for (const char* name : {"p", "q"}) scene.create("plume", name);
  scene.create("every", "e");
  scene.create("sum", "s");
  scene.editor.add_attribute(scene.graph.find("e")->id, {.name = "own"});
  const std::vector<std::string> driven = {"e.weight", "e.precise",   "e.axis.y",       "e.tint.r",
                                           "e.size",   "e.points[2]", "e.key[4].value", "e.own",
                                           "s.a",      "s.b",         "s.weights[7]",   "p.keys[3]"};
  for (const std::string& name : driven)
    if (chance(2)) scene.connect(chance(3) && name[0] != 's' ? "s.out" : chance(2) ? "p.out" : "q.out", name);
  for (const auto& [name, value] : std::vector<std::pair<std::string, Value>>{
           {"e.flag", true}, {"e.label", std::string("x")}, {"e.points[1]", 2.0}, {"e.key[4].time", 3.0}})
    if (chance(2)) scene.set(name, value);
  for (const char* name : {"e.count", "e.weight", "s.a"})
    if (chance(3)) scene.editor.lock(scene.plug(name), true);
  return write_scene(scene.graph);
}

TEST(UnknownNodes, WhateverTheyDriveTheSceneIsSavedAsItWas) {
  std::mt19937 random(7);
  int with_kept = 0;
  for (int run = 0; run < 300; ++run) {
    const std::string text = random_scene(random);
    TestScene scene;
    read_scene(text, "a.pln", scene.registry, scene.editor);
    with_kept += !scene.graph.find("e")->kept.empty();
    ASSERT_EQ(write_scene(scene.graph), text);
    EXPECT_EQ(revive_nodes(scene.editor, scene.registry.add(plume())), std::vector<std::string>());
    ASSERT_EQ(write_scene(scene.graph), text);
    for (const Node* node : scene.graph.nodes()) EXPECT_TRUE(node->kept.empty()) << node->name;
  }
  EXPECT_GT(with_kept, 100);
}

TEST(UnknownNodes, LinesThatMeanNothingStayBetweenTheirNeighbours) {
  TestScene scene;
  scene.create("every", "e");
  scene.set("e.flag", true);
  scene.set("e.weight", 0.25);
  scene.set("e.label", std::string("x"));
  scene.editor.lock(scene.plug("e.count"), true);
  std::string text = write_scene(scene.graph);
  const auto put_before = [&](const std::string& line, const std::string& more) {
    text.insert(text.find(line), more);
  };
  put_before("  .flag", "  .first 1\n");
  put_before("  .weight", "  .second <- nobody.out\n  .third 2\n");
  put_before("  .label", "  .mode nowhere\n");
  put_before("  lock .count", "  .last \"a  b\"\n  lock .first\n");
  TestScene other;
  read_scene(text, "a.pln", other.registry, other.editor);
  EXPECT_EQ(write_scene(other.graph), text);
  // Also where the neighbours have gone.
  other.editor.reset(other.plug("e.weight"));
  EXPECT_NE(write_scene(other.graph).find("  .third 2\n  .mode nowhere\n  .label"), std::string::npos)
      << write_scene(other.graph);
}

TEST(UnknownNodes, WhatANewerVersionMayAddIsKept) {
  const std::string added = "  add tensor field rank 2\n";
  std::string text = scene_with_plume();
  text.insert(text.find("  .density 4"), added);
  TestScene scene;
  read_scene(text, "a.pln", scene.registry, scene.editor);
  EXPECT_EQ(write_scene(scene.graph), text);
  const std::vector<std::string> warnings = revive_nodes(scene.editor, scene.registry.add(plume()));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("unknown attribute type 'tensor'"), std::string::npos) << warnings[0];
  EXPECT_EQ(scene.value("p.density"), Value(4.0f));
  EXPECT_NE(write_scene(scene.graph).find(added), std::string::npos);
}

TEST(UnknownNodes, HoweverNodesStandTheyAreSavedAsTheyStood) {
  std::mt19937 random(5);
  int warned = 0;
  for (int run = 0; run < 300; ++run) {
    // As somebody without the plug-in may have put them.
    TestScene made;
    const NodeTypePtr unknown = NodeType::unknown("plume", 2);
    std::vector<NodeId> all;
    for (int i = 0; i < 12; ++i) {
      std::vector<NodeId> above = {{}};
      for (const NodeId id : all)
        if (made.graph.find(id)->type->spec().holds_children) above.push_back(id);
      const unsigned kind = random() % 3;
      const NodeTypePtr type = kind == 0 ? unknown : made.registry.get(kind == 1 ? "group" : "shape");
      all.push_back(made.editor.create_node(type, "n1", above[random() % above.size()]));
    }
    const std::string text = write_scene(made.graph);

    NodeTypeSpec spec = flat_plume();
    spec.hierarchical = random() % 2;
    TestScene opened;
    const NodeTypePtr type = opened.registry.add(spec);
    warned += read_scene(text, "a.pln", opened.registry, opened.editor).warnings.size() > 0;
    const auto without_types = [](const std::string& scene) {
      return scene.substr(scene.find("node "), scene.find("type ") - scene.find("node "));
    };
    ASSERT_EQ(without_types(write_scene(opened.graph)), without_types(text));
    opened.registry.remove("plume");
    forget_type(opened.editor, type);
    ASSERT_EQ(without_types(write_scene(opened.graph)), without_types(text));
    for (const Node* node : opened.graph.nodes()) ASSERT_FALSE(node->kept_parent) << node->name;
    const NodeTypePtr again = opened.registry.add(spec);
    revive_nodes(opened.editor, again);
    ASSERT_EQ(without_types(write_scene(opened.graph)), without_types(text));
    while (!opened.history.undo_names().empty()) opened.history.undo();
    ASSERT_EQ(opened.graph.size(), 0u);
    while (!opened.history.redo_names().empty()) opened.history.redo();
    ASSERT_EQ(without_types(write_scene(opened.graph)), without_types(text));
  }
  EXPECT_GT(warned, 100);
}

}  // namespace
}  // namespace plinian::graph
