#include "host/graph/edits/editor.h"

#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

TEST(Editor, SetsValuesClampsThemAndRefusesOthersInOneLine) {
  TestScene scene;
  scene.create("every", "e");
  EXPECT_TRUE(scene.editor.set(scene.plug("e.weight"), 0.25));
  EXPECT_FALSE(scene.editor.set(scene.plug("e.weight"), 4.0));
  EXPECT_EQ(scene.value("e.weight"), Value(1.0f));
  scene.set("e.axis.x", 3.0);
  EXPECT_EQ(scene.value("e.axis"), Value(vec3(3.0f, 1.0f, 0.0f)));
  EXPECT_EQ(message_of([&] { scene.set("e.weight", std::string("soft")); }),
            "e.weight expects a value of type float, not a text");
  EXPECT_EQ(message_of([&] { scene.set("e.secret", 1); }), "e.secret is read-only");
  EXPECT_EQ(message_of([&] { scene.set("e.key", 1); }), "e.key is a compound: set its children");
  EXPECT_EQ(message_of([&] { scene.set("e.points", 1.0); }),
            "e.points is an array: name an element, as points[0]");
  scene.create("sum", "s");
  EXPECT_EQ(message_of([&] { scene.set("s.out", 1.0); }), "s.out is computed and cannot be set");
}

TEST(Editor, ADefaultIsNotStoredButAnElementIs) {
  TestScene scene;
  const NodeId id = scene.create("every", "e");
  scene.set("e.weight", 1.0);
  scene.set("e.weight", 0.5);
  EXPECT_TRUE(scene.graph.find(id)->values.empty());
  scene.set("e.points[4]", 0.0);
  scene.set("e.key[2].value", 1.0);
  EXPECT_EQ(scene.graph.find(id)->elements(scene.plug("e.points").attribute), std::vector{4});
  EXPECT_EQ(scene.graph.find(id)->elements(scene.plug("e.key").attribute), std::vector{2});
  scene.editor.reset(scene.plug("e.points"));
  scene.editor.reset(scene.plug("e.key[2]"));
  EXPECT_TRUE(scene.graph.find(id)->values.empty());
}

TEST(Editor, LockedAndConnectedAttributesAreLeftAlone) {
  TestScene scene;
  scene.create("sum", "s");
  scene.create("sum", "t");
  scene.editor.lock(scene.plug("t.a"), true);
  EXPECT_EQ(message_of([&] { scene.set("t.a", 1.0); }), "t.a is locked");
  EXPECT_EQ(message_of([&] { scene.connect("s.out", "t.a"); }), "t.a is locked");
  EXPECT_EQ(message_of([&] { scene.editor.reset(scene.plug("t.a")); }), "t.a is locked");
  scene.editor.lock(scene.plug("t.a"), false);
  scene.connect("s.out", "t.a");
  EXPECT_EQ(message_of([&] { scene.set("t.a", 1.0); }), "t.a is driven by s.out: disconnect it first");
  EXPECT_EQ(message_of([&] { scene.connect("s.vector.x", "t.a"); }),
            "t.a is already driven by s.out: disconnect it first, or connect with -force");
  EXPECT_EQ(
      message_of([&] { scene.connect("s.vector", "t.b"); }),
      "cannot connect s.vector to t.b: float3 cannot drive float; a component may be named as .x or .r");
  EXPECT_EQ(message_of([&] { scene.connect("s.b", "t.out"); }), "t.out is an output and cannot be driven");
  scene.editor.lock(scene.plug("t.weights"), true);
  EXPECT_EQ(message_of([&] { scene.set("t.weights[3]", 1.0); }), "t.weights[3] is locked");
}

TEST(Editor, VectorsAreDrivenAsAWholeOrByComponents) {
  TestScene scene;
  const NodeId t = (scene.create("sum", "s"), scene.create("sum", "t"));
  scene.connect("s.out", "t.offset.y");
  scene.set("t.offset.x", 2.0);
  EXPECT_EQ(message_of([&] { scene.set("t.offset.y", 2.0); }),
            "t.offset.y is driven by s.out: disconnect it first");
  EXPECT_NE(message_of([&] { scene.set("t.offset", vec3(1.0f)); }).find("is driven by"), std::string::npos);
  EXPECT_NE(message_of([&] { scene.connect("s.vector", "t.offset"); }).find("already driven"),
            std::string::npos);
  scene.editor.connect(scene.plug("s.vector"), scene.plug("t.offset"), true);
  EXPECT_EQ(scene.graph.find(t)->inputs.size(), 1u);
  scene.editor.disconnect(scene.plug("t.offset"));
  EXPECT_TRUE(scene.graph.find(t)->inputs.empty());
}

TEST(Editor, AnArrayTakesTheNextFreeElement) {
  TestScene scene;
  const NodeId t = (scene.create("sum", "s"), scene.create("sum", "t"));
  scene.connect("s.out", "t.weights");
  scene.connect("s.vector.z", "t.weights");
  EXPECT_EQ(scene.graph.find(t)->elements(scene.plug("t.weights").attribute), (std::vector{0, 1}));
}

TEST(Editor, DeletingTakesChildrenConnectionsAndFollowersAlong) {
  TestScene scene;
  const NodeId top = scene.create("group", "top");
  scene.create("shape", "leaf", top);
  scene.create("follower", "f");
  scene.create("follower", "g");
  const NodeId other = scene.create("sum", "other");
  scene.connect("f.out", "top.translate.x");
  scene.connect("g.out", "top.translate.y");
  scene.connect("g.out", "other.a");
  scene.editor.select({other, top});
  scene.editor.delete_nodes({top});
  EXPECT_EQ(scene.graph.find("leaf"), nullptr);
  EXPECT_EQ(scene.graph.find("f"), nullptr);
  EXPECT_NE(scene.graph.find("g"), nullptr);  // it still drives something
  EXPECT_EQ(scene.graph.selection(), std::vector{other});
  EXPECT_EQ(scene.history.undo(), "delete");
  EXPECT_EQ(scene.graph.find("leaf")->parent, top);
  EXPECT_EQ(scene.graph.find(top)->inputs.size(), 2u);
  EXPECT_EQ(scene.graph.selection(), (std::vector{other, top}));
}

TEST(Editor, DuplicatesAreDrivenByCopiesAndByOthers) {
  TestScene scene;
  const NodeId s = scene.create("sum", "s"), t = scene.create("sum", "t"), u = scene.create("sum", "u");
  scene.connect("s.out", "t.a");
  scene.connect("u.out", "t.b");
  scene.set("s.a", 3.0);
  const auto copies = scene.editor.duplicate({s, t});
  EXPECT_EQ(scene.graph.find(copies[0])->name, "s1");
  EXPECT_EQ(scene.value("s1.a"), Value(3.0f));
  ASSERT_EQ(scene.graph.find(copies[1])->inputs.size(), 2u);
  EXPECT_EQ(scene.graph.find(copies[1])->inputs[0].source.node, copies[0]);
  EXPECT_EQ(scene.graph.find(copies[1])->inputs[1].source.node, u);
}

TEST(Editor, AddsAttributesToASingleNode) {
  TestScene scene;
  scene.create("sum", "s");
  scene.create("sum", "t");
  scene.editor.add_attribute(scene.graph.find("s")->id, {.name = "shot", .type = AttributeType::string});
  scene.set("s.shot", std::string("A010"));
  EXPECT_EQ(scene.value("s.shot"), Value(std::string("A010")));
  EXPECT_THROW(scene.plug("t.shot"), GraphError);
  EXPECT_EQ(message_of([&] { scene.editor.add_attribute(scene.graph.find("s")->id, {.name = "a"}); }),
            "s: attribute 'a' is there twice");
  scene.history.undo();
  scene.history.undo();
  EXPECT_THROW(scene.plug("s.shot"), GraphError);
  scene.history.redo();
  scene.history.redo();
  EXPECT_EQ(scene.value("s.shot"), Value(std::string("A010")));
}

}  // namespace
}  // namespace plinian::graph
