#include "host/scene/placed.h"
#include "tests/host/scene/test_workspace.h"

namespace plinian::scene {
namespace {

struct Parenting : TestWorkspace {
  Parenting() {
    run("createNode transform -name above\nsetAttr above.translate 10 0 0\nsetAttr above.rotate 0 90 0\n"
        "setAttr above.scale 2 2 2\ncreateNode transform -name thing\nsetAttr thing.translate 1 2 3\n"
        "setAttr thing.rotate 0 30 0");
  }
  dmat4 world(const std::string& name) {
    return Placed(session().graph(), session().evaluator()).world_matrix(session().graph().get(name).id);
  }
  void expect_at(const std::string& name, const dmat4& wanted) {
    const dmat4 now = world(name);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(glm::length(now[i] - wanted[i]), 0.0, 1e-9) << name << ", column " << i;
  }
};

TEST(ParentCommand, WhatIsPutUnderAnotherStaysWhereItIs) {
  Parenting w;
  const dmat4 before = w.world("thing");
  const std::string text = w.run("getAttr thing.translate");
  w.run("parent thing above");
  w.expect_at("thing", before);
  // By hand: a quarter turn back and half the size of (1, 2, 3) - (10, 0, 0).
  EXPECT_EQ(w.run("getAttr thing.translate"), "translate.x -1.5\ntranslate.y 1\ntranslate.z -4.5");
  EXPECT_EQ(w.run("getAttr thing.rotate.y"), "-60");
  EXPECT_EQ(w.run("getAttr thing.scale.x"), "0.5");
  w.run("parent -world thing");
  w.expect_at("thing", before);
  EXPECT_EQ(w.run("getAttr thing.translate"), text) << "there and back reads as before";
  w.run("undo 2");
  EXPECT_FALSE(w.session().graph().get("thing").parent);
  EXPECT_EQ(w.run("getAttr thing.translate"), text);
  EXPECT_TRUE(w.warnings.empty());
}

TEST(ParentCommand, RelativeKeepsTheValues) {
  Parenting w;
  const std::string text = w.run("getAttr thing.translate");
  w.run("parent -relative thing above");
  EXPECT_EQ(w.run("getAttr thing.translate"), text);
}

TEST(ParentCommand, WhatCannotBeWrittenIsTold) {
  Parenting w;
  w.run("setKeyframe thing.translate.x -time 1 -value 1");
  w.run("parent thing above");
  ASSERT_EQ(w.warnings.size(), 1u);
  EXPECT_EQ(w.warnings[0],
            "parent: thing keeps its own values, and moves in the world: thing.translate.x is keyed "
            "(thing_translate_x): setKeyframe sets it at a frame, cutKey takes its keys away");
  EXPECT_EQ(w.run("getAttr thing.scale.x"), "1") << "all of it or nothing";
  w.warnings.clear();
  w.run("undo\nsetAttr above.scale 4 1 1\nsetAttr above.rotate 0 0 0\nparent thing above");
  ASSERT_EQ(w.warnings.size(), 1u);
  EXPECT_TRUE(w.warnings[0].starts_with("parent: thing keeps its own values")) << "it is keyed";
  w.warnings.clear();
  w.run("undo\ncutKey thing.translate.x\nparent thing above");
  ASSERT_EQ(w.warnings.size(), 1u);
  EXPECT_TRUE(w.warnings[0].starts_with("parent: thing changes its shape: ")) << w.warnings[0];
  w.warnings.clear();
  w.run("undo\nsetAttr above.scale 0 1 1\nparent thing above");
  ASSERT_EQ(w.warnings.size(), 1u);
  EXPECT_TRUE(w.warnings[0].ends_with(": its parent is scaled by 0")) << w.warnings[0];
}

TEST(ParentCommand, ALightKeepsItsDirectionUnderAStretchedParent) {
  Parenting w;
  w.run("createNode directionalLight -name sun\nsetAttr sun.rotate 20 40 0");
  const dvec3 before = glm::normalize(dvec3(w.world("sun")[2]));
  w.run("parent sun above");
  const dvec3 after = glm::normalize(dvec3(w.world("sun")[2]));
  EXPECT_NEAR(glm::distance(before, after), 0.0, 1e-9);
  EXPECT_TRUE(w.warnings.empty());
}

}  // namespace
}  // namespace plinian::scene
