// A scene outlives the plug-ins that it was made with.
#include "host/graph/files/unknown_nodes.h"

#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
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
            "node 'p' (plume) has no attribute 'density', whose type plume is not known here");
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

}  // namespace
}  // namespace plinian::graph
