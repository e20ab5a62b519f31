#include "host/graph/model/graph.h"

#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

TEST(Graph, NamesAreUniqueAndTheLowestFreeNumberIsTaken) {
  TestScene scene;
  const NodeId first = scene.create("sum", "");
  EXPECT_EQ(scene.graph.find(first)->name, "sum1");
  EXPECT_EQ(scene.graph.find(scene.create("sum", ""))->name, "sum2");
  EXPECT_EQ(scene.graph.find(scene.create("sum", "ash:a"))->name, "ash:a");
  EXPECT_EQ(scene.graph.find(scene.create("sum", "ash:a"))->name, "ash:a1");
  scene.editor.delete_nodes({first});
  EXPECT_EQ(scene.graph.find(scene.create("sum", "sum2"))->name, "sum1");
  EXPECT_EQ(message_of([&] { scene.create("sum", "2x"); }),
            "'2x' cannot name a node: a letter or _, then letters, digits and _, with ':' after a namespace");
}

TEST(Graph, PlugsHaveNamesWithElementsAndComponents) {
  TestScene scene;
  scene.create("every", "e");
  for (const char* name :
       {"e.weight", "e.key[3].time", "e.points[0]", "e.axis.z", "e.tint.g", "e.key", "e.four.w"})
    EXPECT_EQ(scene.graph.name_of(scene.plug(name)), name);
  EXPECT_EQ(scene.plug("e.tint.b").component, 2);
  EXPECT_EQ(message_of([&] { scene.plug("e"); }), "'e' names no attribute: write NODE.ATTRIBUTE");
  EXPECT_EQ(message_of([&] { scene.plug("f.x"); }), "there is no node 'f' (did you mean 'e'?)");
  EXPECT_EQ(message_of([&] { scene.plug("e.wieght"); }),
            "node 'e' (every) has no attribute 'wieght' (did you mean 'weight'?)");
  EXPECT_EQ(message_of([&] { scene.plug("e.weight[1]"); }), "e: 'weight[1]' is no array there");
  EXPECT_EQ(message_of([&] { scene.plug("e.key.time[1]"); }), "e: 'key.time[1]' is no array there");
  EXPECT_NE(message_of([&] { scene.plug("e.points[-1]"); }).find("an element is written"), std::string::npos);
  EXPECT_NE(message_of([&] { scene.plug("e.points[1"); }).find("an element is written"), std::string::npos);
  EXPECT_NE(message_of([&] { scene.plug("e.axis.w"); }).find("no attribute 'axis.w'"), std::string::npos);
}

TEST(Graph, ASnapshotStaysWhatItWas) {
  TestScene scene;
  const NodeId id = scene.create("every", "e");
  const GraphSnapshotPtr before = scene.graph.snapshot();
  EXPECT_EQ(before, scene.graph.snapshot());
  scene.set("e.weight", 1.0);
  scene.editor.rename(id, "f");
  const GraphSnapshotPtr after = scene.graph.snapshot();
  scene.editor.delete_nodes({id});
  const AttributeIndex weight = before->find(id)->schema->find("weight");
  EXPECT_EQ(before->find(id)->name, "e");
  EXPECT_EQ(before->find(id)->value(weight), Value(0.5f));
  EXPECT_EQ(after->find(id)->name, "f");
  EXPECT_EQ(after->find(id)->value(weight), Value(1.0f));
  EXPECT_EQ(scene.graph.snapshot()->find(id), nullptr);
}

TEST(Graph, ObserversHearOfEveryEdit) {
  struct Counter : GraphObserver {
    int edits = 0;
    void edited(const Edit&) override { ++edits; }
  } counter;
  TestScene scene;
  scene.graph.add_observer(&counter);
  scene.create("every", "e");
  scene.set("e.weight", 1.0);
  EXPECT_EQ(counter.edits, 2);
  scene.set("e.weight", 1.0);  // equal: nothing happens
  EXPECT_EQ(counter.edits, 2);
  scene.history.undo();
  EXPECT_EQ(counter.edits, 3);
  scene.graph.remove_observer(&counter);
}

}  // namespace
}  // namespace plinian::graph
