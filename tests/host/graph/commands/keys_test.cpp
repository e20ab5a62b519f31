// Keys: what they make, how they are set and held, and that copies have their own.
#include "tests/host/graph/commands/test_session.h"

namespace plinian::graph {
namespace {

// What its curve holds is the attribute's, although it is another node's.
TEST(Keys, ALockHoldsForKeysAndAKeyedAttributeSaysHowItIsSet) {
  TestSession s;
  s.run("createNode sum -name y\ncreateNode sum -name x\nsetKeyframe y.a -time 1 -value 3\nlockAttr y.a");
  EXPECT_EQ(s.refusal("setKeyframe y.a -time 2 -value 5"), "y.a is locked");
  EXPECT_EQ(s.refusal("cutKey y.a -time 1"), "y.a is locked");
  EXPECT_EQ(s.run("getAttr y.a -time 2"), "3");
  s.run("lockAttr -off y.a");
  EXPECT_EQ(s.refusal("setAttr y.a 1"),
            "y.a is keyed (y_a): setKeyframe sets it at a frame, cutKey takes its keys away");
  s.run("connectAttr x.out y.b");
  EXPECT_EQ(s.refusal("setKeyframe y.b"), "y.b is driven by x.out: disconnectAttr y.b lets it be keyed");
}

TEST(Keys, ACopyHasKeysOfItsOwn) {
  TestSession s;
  s.run(
      "createNode group -name g\nsetKeyframe g.translate.x -time 1 -value 0 -interpolation linear\n"
      "setKeyframe g.translate.x -time 10 -value 9\ncurrentTime 10\nduplicate g");
  EXPECT_EQ(s.run("getAttr g1.translate.x\ngetAttr g1.translate.x -time 4"), "9\n3");
  s.run("setKeyframe g1.translate.x -time 10 -value 90");
  EXPECT_EQ(s.run("getAttr g.translate.x\ngetAttr g1.translate.x"), "9\n90");
  s.run("duplicate g -shareKeys");
  EXPECT_EQ(s.run("listConnections g2"), "g_translate_x.out -> g2.translate.x");
}

TEST(Keys, ACopyIsDrivenByWhatDrivesTheOriginal) {
  TestSession s;
  s.run(
      "createNode sum -name x\ncreateNode sum -name y\nconnectAttr x.out y.a\nsetKeyframe y.b -time 1 -value "
      "3\nduplicate y");
  EXPECT_EQ(s.run("listConnections y1"), "x.out -> y1.a\ny_b1.out -> y1.b");
}

TEST(Keys, SwitchesAndChoicesAreKeyedInSteps) {
  TestSession s;
  s.run(
      "createNode every -name e\nsetKeyframe e.flag -time 1 -value off\nsetKeyframe e.flag -time 10 -value "
      "on\n"
      "setKeyframe e.mode -time 1 -value off\nsetKeyframe e.mode -time 10 -value high");
  EXPECT_EQ(s.run("getAttr e.flag -time 9\ngetAttr e.flag -time 10"), "false\ntrue");
  EXPECT_EQ(s.run("getAttr e.mode -time 9\ngetAttr e.mode -time 10"), "off\nhigh");
  EXPECT_EQ(s.run("getAttr e_flag.key[0].interpolation"), "stepped");
  s.run("setKeyframe e.flag -time 1 -value off -interpolation linear\nsetKeyframe e.flag -time 1 -value on");
  EXPECT_EQ(s.run("getAttr e_flag.key[0].interpolation"), "linear") << "as it was asked for";
}

TEST(Keys, KeysMakeCurvesAndCuttingThemFreesTheAttribute) {
  TestSession s;
  s.run("createNode group -name g\nsetAttr g.translate 1 2 3\ncurrentTime 10\n");
  EXPECT_EQ(s.run("setKeyframe g.translate -interpolation linear"),
            "g_translate_x\ng_translate_y\ng_translate_z");
  EXPECT_EQ(s.run("setKeyframe g.translate.y -time 20 -value 12"), "g_translate_y");
  EXPECT_EQ(s.run("currentTime 15\ngetAttr g.translate"), "15\n1 7 3");
  EXPECT_EQ(s.run("getAttr g.translate.y -time 11"), "3");
  EXPECT_EQ(s.run("setKeyframe g.translate.y -time 20 -value 22\ngetAttr g.translate.y"),
            "g_translate_y\n12");
  EXPECT_EQ(s.run("cutKey g.translate.y -time 20\ngetAttr g.translate"), "1\n1 2 3");
  EXPECT_EQ(s.run("cutKey g.translate\nlistConnections g\nls -type animCurve"), "3");
  EXPECT_EQ(s.run("getAttr g.translate"), "1 2 3");
  EXPECT_EQ(s.run("undo\ngetAttr g.translate.y -time 11"), "cutKey g.translate\n2");
  s.run("delete g");
  EXPECT_EQ(s.run("ls -type animCurve"), "");
  // Time is no edit.
  EXPECT_EQ(s.run("currentTime 33\nundo\ncurrentTime"), "33\ndelete g\n33");
}

}  // namespace
}  // namespace plinian::graph
