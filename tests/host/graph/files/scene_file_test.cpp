#include "host/graph/files/scene_reader.h"
#include "host/graph/files/scene_writer.h"
#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

SceneReport read(TestScene& scene, const std::string& text, const std::string& name_space = "") {
  return read_scene(text, "a.pln", scene.registry, scene.editor, name_space);
}

std::string all(const std::vector<std::string>& lines) {
  std::string result;
  for (const std::string& line : lines) result += line + "\n";
  return result;
}

// Without the sections of types, which say what is left out.
std::string nodes_of(const std::string& text) {
  return text.substr(0, text.find("type "));
}

void fill(TestScene& scene) {
  const NodeId top = scene.create("group", "cloud");
  scene.create("shape", "ash:core", top);
  scene.create("sum", "s");
  scene.create("every", "e");
  scene.set("cloud.translate", vec3(0.0f, 2.5f, 0.0f));
  scene.set("e.flag", true);
  scene.set("e.weight", 0.1);
  scene.set("e.mode", 30);
  scene.set("e.label", std::string("two \"words\""));
  scene.set("e.file", std::string("$SHOW/ash.####.vdb"));
  scene.set("e.tint", vec3(1.0f, 0.25f, 0.0f));
  scene.set("e.target", scene.graph.find("ash:core")->id);
  scene.set("e.key[7].time", 24.0);
  scene.set("e.key[7].value", 0.0);
  scene.editor.add_attribute(
      scene.graph.find("e")->id,
      {.name = "glow",
       .type = AttributeType::compound,
       .children = {{.name = "amount", .minimum = 0.0}, {.name = "on", .type = AttributeType::boolean}}});
  scene.set("e.glow.amount", 3.0);
  scene.connect("s.out", "e.points[0]");
  scene.connect("s.out", "e.axis.y");
  scene.connect("e.tint.r", "s.a");
  scene.editor.lock(scene.plug("e.count"), true);
}

const char* const filled = R"(plinian scene 1.0
node group cloud
  .translate 0 2.5 0
node shape ash:core under cloud
node sum s
  .a <- e.tint.r
node every e
  add compound glow
  add float glow.amount min 0
  add bool glow.on
  .flag true
  .weight 0.1
  .mode high
  .label "two \"words\""
  .file "$SHOW/ash.####.vdb"
  .axis.y <- s.out
  .tint 1 0.25 0
  .target ash:core
  .points[0] <- s.out
  .key[7].time 24
  .key[7].value 0
  .glow.amount 3
  lock .count
)";

TEST(SceneFile, ReadsLikeWhatItIs) {
  TestScene scene;
  fill(scene);
  const std::string text = write_scene(scene.graph);
  EXPECT_EQ(nodes_of(text), filled);
  EXPECT_NE(text.find("type group 1\n  .translate 0 0 0\n  .visibility true\ntype shape 1\n  .size 0\n"),
            std::string::npos);
  EXPECT_TRUE(text.ends_with("end\n"));
  EXPECT_EQ(text.find(".volume"), std::string::npos);  // data are not stored
}

TEST(SceneFile, ComesBackByteForByteAndAsOneStep) {
  TestScene scene, other;
  fill(scene);
  const std::string text = write_scene(scene.graph);
  const SceneReport report = read(other, text);
  EXPECT_EQ(all(report.warnings), "");
  EXPECT_EQ(report.nodes.size(), 4u);
  EXPECT_EQ(write_scene(other.graph), text);
  EXPECT_EQ(message_of([&] { other.set("e.count", 3); }), "e.count is locked");
  EXPECT_EQ(other.graph.find(other.plug("e.target").node)->value(other.plug("e.target").attribute),
            Value(other.graph.find("ash:core")->id));
  other.history.undo();
  EXPECT_EQ(other.graph.size(), 0u);
}

TEST(SceneFile, IsImportedUnderANamespaceAndNamesStayUnique) {
  TestScene scene, other;
  fill(scene);
  const std::string text = write_scene(scene.graph);
  read(other, text, "left");
  read(other, text, "left");
  EXPECT_NE(other.graph.find("left:ash:core"), nullptr);
  EXPECT_EQ(other.graph.find("left:s1")->inputs.at(0).source.node, other.graph.find("left:e1")->id);
  EXPECT_EQ(other.graph.find("left:ash:core1")->parent, other.graph.find("left:cloud1")->id);
}

TEST(SceneFile, AnExportHoldsTheNodesAskedForAndNoLooseEnds) {
  TestScene scene, other;
  fill(scene);
  const std::string text = write_scene(scene.graph, {scene.graph.find("e")->id});
  const SceneReport report = read(other, text);
  EXPECT_EQ(report.nodes.size(), 1u);
  EXPECT_EQ(text.find("<-"), std::string::npos);
}

struct Versioned {
  TypeRegistry registry;
  Graph graph;
  History history{graph};
  Editor editor{graph, history};
  std::string value(const std::string& name) const {
    const Plug plug = graph.plug(name);
    return write_value(graph.attribute(plug).spec,
                       graph.find(plug.node)->value(plug.attribute, plug.element));
  }
};

TEST(SceneFile, AChangedDefaultNeverChangesAnOldScene) {
  Versioned old;
  old.registry.add({.name = "n",
                    .attributes = {{.name = "x", .default_value = 1.0},
                                   {.name = "zero"},
                                   {.name = "list",
                                    .type = AttributeType::compound,
                                    .array = true,
                                    .children = {{.name = "p", .default_value = 2.0}, {.name = "q"}}}}});
  old.editor.create_node(old.registry.get("n"), "a");
  old.editor.create_node(old.registry.get("n"), "b");
  old.editor.set(old.graph.plug("b.x"), 5.0);
  old.editor.set(old.graph.plug("a.list[0].q"), 1.0);
  const std::string text = write_scene(old.graph);

  Versioned now;
  now.registry.add({.name = "n",
                    .attributes = {{.name = "x", .default_value = 5.0},
                                   {.name = "zero", .default_value = 3.0},
                                   {.name = "list",
                                    .type = AttributeType::compound,
                                    .array = true,
                                    .children = {{.name = "p", .default_value = 7.0}, {.name = "q"}}},
                                   {.name = "fresh", .default_value = 9.0}}});
  read_scene(text, "a.pln", now.registry, now.editor);
  EXPECT_EQ(now.value("a.x"), "1");
  EXPECT_EQ(now.value("b.x"), "5");
  EXPECT_EQ(now.value("a.zero"), "0");
  EXPECT_EQ(now.value("a.fresh"), "9");  // was not there: nothing to keep
  EXPECT_EQ(now.value("a.list[0].p"), "2");
  now.editor.create_node(now.registry.get("n"), "c");
  EXPECT_EQ(now.value("c.x"), "5");
}

TEST(SceneFile, MigratorsAndAliasesReadOlderScenes) {
  Versioned old;
  old.registry.add(
      {.name = "n", .attributes = {{.name = "extinction", .default_value = 2.0}, {.name = "wt"}}});
  for (const char* name : {"a", "b"}) old.editor.create_node(old.registry.get("n"), name);
  old.editor.set(old.graph.plug("a.extinction"), 8.0);
  old.editor.set(old.graph.plug("a.wt"), 0.5);
  const std::string text = write_scene(old.graph);

  Versioned now;
  now.registry.add(
      {.name = "n",
       .version = 3,
       .attributes = {{.name = "mean_free_path", .default_value = 1.0}, {.name = "weight"}},
       .migrators = {{1,
                      [](StoredAttributes& attributes) {
                        for (StoredAttribute& attribute : attributes)
                          if (attribute.path == "extinction")
                            attribute = {"path", write_number(1.0 / read_number(attribute.text))};
                      }},
                     {2,
                      [](StoredAttributes& attributes) {
                        for (StoredAttribute& attribute : attributes)
                          if (attribute.path == "path") attribute.path = "mean_free_path";
                      }}},
       .aliases = {{"wt", "weight"}}});
  const SceneReport report = read_scene(text, "a.pln", now.registry, now.editor);
  EXPECT_EQ(all(report.warnings), "");
  EXPECT_EQ(now.value("a.mean_free_path"), "0.125");
  EXPECT_EQ(now.value("b.mean_free_path"), "0.5");  // from the default of then
  EXPECT_EQ(now.value("a.weight"), "0.5");
  EXPECT_EQ(now.value("a.wt"), "0.5");
  EXPECT_NE(write_scene(now.graph).find("type n 3"), std::string::npos);
}

TEST(SceneFile, ANewerMinorVersionIsKeptWordForWordAndANewerMajorOneIsReadOnly) {
  TestScene scene;
  const std::string text = R"(plinian scene 1.7
layer beauty
  colour red
node sum s
  .a 2
  tag "hero"
)";
  const SceneReport report = read(scene, text + "end\n");
  EXPECT_FALSE(report.read_only);
  EXPECT_EQ(report.warnings.at(0),
            "a.pln: was saved in the newer format 1.7: what is not known here is kept as it is");
  const std::string again = write_scene(scene.graph);
  EXPECT_TRUE(again.starts_with(
      "plinian scene 1.0\nlayer beauty\n  colour red\nnode sum s\n  .a 2\n  tag \"hero\"\n"))
      << again;
  TestScene other;
  EXPECT_TRUE(read(other, "plinian scene 2.0\nnode sum s\nend\n").read_only);
  EXPECT_NE(other.graph.find("s"), nullptr);
}

TEST(SceneFile, WhatStandsBehindItsEndIsRefusedRatherThanLost) {
  TestScene scene;
  const std::string text = "plinian scene 1.0\nnode sum s\nend\n";
  read(scene, text + "\n  \n");
  EXPECT_EQ(message_of([&] { read(scene, text + "\nnode sum t\n"); }),
            "a.pln:5: stands behind 'end', where a scene is over: 'node sum t'");
  EXPECT_EQ(message_of([&] { read(scene, text + "  .a 3"); }),
            "a.pln:4: stands behind 'end', where a scene is over: '  .a 3'");
}

TEST(SceneFile, WhatCannotBeUsedIsSaidAndKept) {
  TestScene scene;
  const std::string nodes = R"(plinian scene 1.0
node every e
  .weight 7
  .mode medium
  .fancy 1   2
  .target nobody
  .flag <- gone.out
  .label <- s.out
node sum s
)";
  const SceneReport report = read(scene, nodes + "end\n");
  EXPECT_EQ(
      all(report.warnings),
      "a.pln:3: e.weight is out of its range (a number from 0 to 1) and was set to 1\n"
      "a.pln:4: e.mode 'medium' is none of off (0), low (10), high (30); the line is kept as it is\n"
      "a.pln:5: node 'e' (every) has no attribute 'fancy'; the line is kept as it is\n"
      "a.pln:6: e.target: there is no node 'nobody'; the line is kept as it is\n"
      "a.pln:7: e.flag: there is no node for the connection from 'gone.out'; the line is kept as it is\n"
      "a.pln:8: cannot connect s.out to e.label: float cannot drive string; the line is kept as it is\n");
  const std::string again = write_scene(scene.graph);
  for (const char* line : {"  .mode medium\n", "  .fancy 1   2\n", "  .target nobody\n",
                           "  .flag <- gone.out\n", "  .label <- s.out\n", "  .weight 1\n"})
    EXPECT_NE(again.find(line), std::string::npos) << line;
  // A value that is set later wins over the line that was kept.
  scene.set("e.mode", 30);
  TestScene other;
  read(other, write_scene(scene.graph));
  EXPECT_EQ(other.value("e.mode"), Value(30));
}

}  // namespace
}  // namespace plinian::graph
