// Snapshots share pages with the living graph, and never see its edits.
#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

TEST(GraphSnapshot, StaysAsItWasWhateverIsEdited) {
  TestScene s;
  std::vector<NodeId> nodes;
  for (int i = 0; i < 200; ++i) nodes.push_back(s.create("sum", "n1"));
  const GraphSnapshotPtr before = s.graph.snapshot();
  const AttributeIndex a = before->find(nodes[0])->schema->find("a");
  for (const int i : {0, 63, 64, 199}) s.editor.set({nodes[std::size_t(i)], a}, 1.0f + float(i));
  s.editor.delete_nodes({nodes[100]});
  const NodeId late = s.create("sum", "late");
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(before->find(nodes[std::size_t(i)]));
    EXPECT_EQ(before->find(nodes[std::size_t(i)])->value(a), Value(0.0f));
  }
  EXPECT_FALSE(before->find(late));
  EXPECT_FALSE(s.graph.find(nodes[100]));
  const GraphSnapshotPtr after = s.graph.snapshot();
  EXPECT_EQ(after->find(nodes[63])->value(a), Value(64.0f));
  EXPECT_FALSE(after->find(nodes[100]));
  EXPECT_TRUE(after->find(late));
  EXPECT_FALSE(after->find(NodeId{100'000}));
}

TEST(GraphSnapshot, SharesWhatDidNotChange) {
  TestScene s;
  std::vector<NodeId> nodes;
  for (int i = 0; i < 200; ++i) nodes.push_back(s.create("sum", "n1"));
  const GraphSnapshotPtr before = s.graph.snapshot();
  const AttributeIndex a = before->find(nodes[0])->schema->find("a");
  s.editor.set({nodes[5], a}, 2.0f);
  const GraphSnapshotPtr after = s.graph.snapshot();
  for (int i = 0; i < 200; ++i)
    EXPECT_EQ(before->find(nodes[std::size_t(i)]) == after->find(nodes[std::size_t(i)]), i != 5);
  EXPECT_EQ(s.graph.snapshot(), after);  // the same object until the next edit
}

}  // namespace
}  // namespace plinian::graph
