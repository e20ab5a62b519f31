#include "host/graph/model/hierarchy.h"

#include "tests/host/graph/test_scene.h"

namespace plinian::graph {
namespace {

struct Family : TestScene {
  NodeId top = create("group", "top"), middle = create("group", "middle", top),
         leaf = create("shape", "leaf", middle), other = create("shape", "other");
};

TEST(Hierarchy, ChildrenAreUnderTheirParents) {
  Family f;
  EXPECT_EQ(ancestors(f.graph, f.leaf), (std::vector{f.middle, f.top}));
  EXPECT_EQ(with_descendants(f.graph, {f.leaf, f.top}), (std::vector{f.top, f.middle, f.leaf}));
  EXPECT_EQ(f.graph.children({}), (std::set{f.top, f.other}));
  f.editor.set_parent({f.middle}, {});
  EXPECT_EQ(f.graph.children({}), (std::set{f.top, f.middle, f.other}));
  EXPECT_EQ(message_of([&] { f.editor.set_parent({f.middle}, f.other); }),
            "other (shape) cannot be a parent: only transforms can");
  EXPECT_EQ(message_of([&] { f.create("sum", "s", f.top); }),
            "s (sum) has no place in the transform hierarchy");
  f.editor.set_parent({f.middle}, f.top);
  EXPECT_EQ(message_of([&] { f.editor.set_parent({f.top}, f.middle); }),
            "top cannot be under itself: top -> middle");
}

TEST(Hierarchy, WhatIsUnderAHiddenNodeIsHidden) {
  Family f;
  EXPECT_TRUE(is_visible(f.graph, f.leaf));
  f.set("top.visibility", false);
  EXPECT_FALSE(is_visible(f.graph, f.leaf));
  EXPECT_TRUE(is_visible(f.graph, f.other));
}

TEST(Hierarchy, IsolatingShowsANodeWithWhatIsAboveAndUnderIt) {
  Family f;
  EXPECT_TRUE(is_shown(f.graph, f.leaf, {f.middle}));
  EXPECT_TRUE(is_shown(f.graph, f.top, {f.middle}));
  EXPECT_FALSE(is_shown(f.graph, f.other, {f.middle}));
  EXPECT_TRUE(is_shown(f.graph, f.other, {}));
  f.set("top.visibility", false);
  EXPECT_FALSE(is_shown(f.graph, f.leaf, {f.leaf}));
}

}  // namespace
}  // namespace plinian::graph
