#include "host/graph/edits/history.h"

#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

TEST(History, UndoesAndRedoesByName) {
  TestScene scene;
  {
    const History::Scope scope(scene.history, "build");
    scene.create("sum", "s");
    scene.create("sum", "t");
    scene.connect("s.out", "t.a");
  }
  EXPECT_EQ(scene.history.undo_names(), std::vector<std::string>{"build"});
  EXPECT_EQ(scene.history.undo(), "build");
  EXPECT_EQ(scene.graph.size(), 0u);
  EXPECT_EQ(scene.history.undo(), "");
  EXPECT_EQ(scene.history.redo(), "build");
  EXPECT_EQ(scene.graph.find("t")->inputs.size(), 1u);
  scene.history.undo();
  scene.create("sum", "u");  // what was undone is gone now
  EXPECT_EQ(scene.history.redo(), "");
}

TEST(History, AScopeThatThrowsTakesBackWhatItDid) {
  TestScene scene;
  scene.create("sum", "s");
  const History::Scope outer(scene.history, "outer");
  scene.set("s.a", 1.0);
  EXPECT_THROW(
      {
        const History::Scope inner(scene.history, "inner");
        scene.set("s.a", 2.0);
        scene.set("s.out", 2.0);
      },
      GraphError);
  EXPECT_EQ(scene.value("s.a"), Value(1.0f));
}

TEST(History, ADragIsOneStep) {
  TestScene scene;
  scene.create("sum", "s");
  const auto drag = [&](double value, const std::string& key) {
    const History::Scope scope(scene.history, "setAttr", key);
    scene.set("s.a", value);
    scene.set("s.b", value * 2.0);
  };
  for (int i = 1; i <= 1000; ++i) drag(i, "drag 1");
  EXPECT_EQ(scene.history.undo_names().size(), 2u);
  for (int i = 1; i <= 10; ++i) drag(-i, "drag 2");
  scene.history.end_merge();
  drag(-20, "drag 2");
  EXPECT_EQ(scene.history.undo_names().size(), 4u);
  scene.history.undo();
  EXPECT_EQ(scene.value("s.b"), Value(-20.0f));
  scene.history.undo();
  EXPECT_EQ(scene.value("s.b"), Value(2000.0f));
  scene.history.undo();
  EXPECT_EQ(scene.value("s.a"), Value(0.0f));
  scene.history.redo();
  EXPECT_EQ(scene.value("s.a"), Value(1000.0f));
  drag(7, "drag 1");  // nothing merges with a step that was redone
  scene.history.undo();
  EXPECT_EQ(scene.value("s.a"), Value(1000.0f));
}

TEST(History, KnowsWhetherTheSceneDiffersFromTheSavedOne) {
  TestScene scene;
  EXPECT_FALSE(scene.history.is_modified());
  const NodeId s = scene.create("sum", "s");
  EXPECT_TRUE(scene.history.is_modified());
  scene.history.mark_saved();
  scene.editor.select({s});  // a selection is undone, but no change of the scene
  EXPECT_FALSE(scene.history.is_modified());
  scene.set("s.a", 1.0);
  EXPECT_TRUE(scene.history.is_modified());
  scene.history.undo();
  EXPECT_FALSE(scene.history.is_modified());
  scene.history.undo();
  scene.history.undo();
  EXPECT_TRUE(scene.history.is_modified());
  scene.create("sum", "t");  // the saved state cannot be reached any more
  EXPECT_TRUE(scene.history.is_modified());
}

}  // namespace
}  // namespace plinian::graph
