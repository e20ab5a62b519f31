// Each mistake costs one clear line and changes nothing.
#include "tests/host/graph/commands/test_session.h"

namespace plinian::graph {
namespace {

struct BadCommand : ::testing::Test {
  TestSession s;
  BadCommand() {
    s.run(
        "createNode every -name e\ncreateNode sum -name x\ncreateNode sum -name y\nconnectAttr x.out y.a\n"
        "lockAttr e.label\n");
  }
};

TEST_F(BadCommand, UnknownThingsComeWithTheNearestWord) {
  EXPECT_EQ(s.refusal("setAtr e.weight 1"), "unknown command 'setAtr' (did you mean 'setAttr'?)");
  EXPECT_EQ(s.refusal("createNode evry"), "unknown node type 'evry' (did you mean 'every'?)");
  EXPECT_EQ(s.refusal("setAttr e.wieght 1"),
            "node 'e' (every) has no attribute 'wieght' (did you mean 'weight'?)");
  EXPECT_EQ(s.refusal("setAttr f.weight 1"), "there is no node 'f' (did you mean 'e'?)");
  EXPECT_EQ(s.refusal("ls -typ sum"), "ls: unknown flag '-typ' (did you mean '-type'?)");
  for (const char* other : {"--dataType", "-data-type", "--data_type"})
    EXPECT_EQ(s.refusal("addAttr e z " + std::string(other) + " a"),
              "addAttr: unknown flag '" + std::string(other) + "' (did you mean '-dataType'?)");
  EXPECT_EQ(s.refusal("undo -quickly"), "undo: unknown flag '-quickly'; it takes none");
  EXPECT_TRUE(s.refusal("ls -l").starts_with("ls: unknown flag '-l'; there are: -")) << s.refusal("ls -l");
  EXPECT_EQ(s.refusal("ls -type smu"), "unknown node type 'smu' (did you mean 'sum'?)");
  EXPECT_EQ(s.refusal("addAttr e z -type flaot"),
            "addAttr: unknown attribute type 'flaot' (did you mean 'float'?)");
  EXPECT_EQ(s.refusal("delete z*"), "no node matches 'z*'");
  EXPECT_EQ(s.refusal("help setattr"), "unknown command 'setattr' (did you mean 'setAttr'?)");
}

TEST_F(BadCommand, ValuesOfTheWrongTypeSayWhatIsExpected) {
  EXPECT_EQ(s.refusal("setAttr e.weight soft"), "e.weight expects a number from 0 to 1, not 'soft'");
  EXPECT_EQ(s.refusal("setAttr e.axis 1 2"), "e.axis expects 3 numbers, not '1 2'");
  EXPECT_EQ(s.refusal("setAttr e.mode medium"), "e.mode 'medium' is none of off (0), low (10), high (30)");
  EXPECT_EQ(s.refusal("setAttr e.file two words"),
            "e.file expects one text: put it in quotes, \"two words\"");
  EXPECT_EQ(
      s.refusal("setAttr e.profile 1"),
      "e.profile expects points POSITION:VALUE:INTERPOLATION (stepped, linear or smooth) in ascending order, "
      "or \"\" for none, not '1'");
  EXPECT_EQ(s.refusal("createNode group -parent nobody"), "createNode: -parent: there is no node 'nobody'");
  EXPECT_EQ(s.refusal("createNode group -parent x"),
            "createNode: -parent: x (sum) cannot be a parent: only transforms can");
  EXPECT_EQ(s.refusal("createNode sum -parent x"),
            "createNode: -parent: a sum has no place in the transform hierarchy: leave it out");
  EXPECT_EQ(s.refusal("setAttr e.target nobody"),
            "e.target expects a node or none, and there is no node 'nobody'");
  EXPECT_EQ(s.refusal("setAttr e.volume 3"),
            "e.volume holds data of type 'volume', which have no text form here");
  EXPECT_EQ(s.refusal("currentTime soon"), "currentTime: TIME expects a number, not 'soon'");
  EXPECT_EQ(s.refusal("setKeyframe e.profile"), "e.profile is of type ramp, which has no numbers to animate");
  EXPECT_EQ(s.refusal("setKeyframe e.weight -interpolation bouncy"),
            "setKeyframe: -interpolation: 'bouncy' is none of stepped (0), linear (1), smooth (2)");
}

TEST_F(BadCommand, WhatIsLockedDrivenOrWouldCloseACycleIsRefused) {
  EXPECT_EQ(s.refusal("setAttr e.label x"), "e.label is locked");
  EXPECT_EQ(s.refusal("setAttr y.a 1"), "y.a is driven by x.out: disconnect it first");
  EXPECT_EQ(s.refusal("connectAttr y.out x.a"),
            "cannot connect y.out to x.a: it would close the cycle x.a -> x.out -> y.a -> y.out -> x.a");
  EXPECT_EQ(s.refusal("disconnectAttr x.a"), "x.a is not driven by anything");
  EXPECT_EQ(s.refusal("setAttr x.out 1"), "x.out is computed and cannot be set");
  EXPECT_EQ(s.refusal("cutKey x.a"), "cutKey: there is no key there");
  EXPECT_EQ(s.refusal("select"), "select: name nodes, or give -clear");
}

TEST_F(BadCommand, ACommandThatFailsHalfwayTakesEverythingBack) {
  EXPECT_EQ(s.refusal("resetAttr x.b e.label"), "e.label is locked");
  s.run("setAttr x.b 3");
  EXPECT_EQ(s.refusal("resetAttr x.b e.label"), "e.label is locked");  // x.b was reset before that
  EXPECT_EQ(s.run("getAttr x.b"), "3");
  s.run("createNode animCurve -name c\nsetKeyframe x.b");
  EXPECT_EQ(s.refusal("setKeyframe x.a e.label"),
            "e.label is of type string, which has no numbers to animate");
}

TEST_F(BadCommand, AScriptNamesFileAndLine) {
  EXPECT_EQ(message_of([&] { s.run("# comment\nsetAttr x.b 1\n\nsetAttr x.c 1\nsetAttr x.b 2"); }),
            "script.pln:4: node 'x' (sum) has no attribute 'c' (did you mean 'a'?)");
  EXPECT_EQ(s.run("getAttr x.b"), "1");
  EXPECT_EQ(message_of([&] { s.run("setAttr e.label \"open"); }), "script.pln:1: a quote is not closed");
}

TEST_F(BadCommand, FilesThatCannotBeReadOrWrittenAreNamed) {
  EXPECT_EQ(s.refusal("open -force /nowhere/a.plinian"),
            "/nowhere/a.plinian: cannot be read: No such file or directory");
  EXPECT_EQ(s.refusal("save /nowhere/a.plinian"),
            "save: /nowhere/a.plinian: cannot be written: the folder /nowhere does not exist");
  EXPECT_EQ(s.refusal("save"), "save: the scene has no file yet: save FILE");
  EXPECT_EQ(s.refusal("undo undo"), "undo: STEPS expects a number, not 'undo'");
  EXPECT_EQ(s.refusal("redo"), "there is nothing to redo");
}

TEST_F(BadCommand, WhatIsMissingIsNamed) {
  EXPECT_EQ(s.refusal("setAttr"), "setAttr: PLUG is missing: setAttr PLUG VALUE...");
  EXPECT_EQ(s.refusal("setAttr x.a"), "setAttr: VALUE is missing: setAttr PLUG VALUE...");
  EXPECT_EQ(s.refusal("connectAttr x.out"),
            "connectAttr: DESTINATION is missing: connectAttr SOURCE DESTINATION");
  EXPECT_EQ(s.refusal("addAttr e"), "addAttr: NAME is missing: addAttr NODE NAME");
  EXPECT_EQ(s.refusal("resetAttr"), "resetAttr: PLUGS is missing: resetAttr PLUGS...");
}

TEST_F(BadCommand, NumbersThatCannotBeMeantAreRefused) {
  EXPECT_EQ(s.refusal("undo -3"), "undo: STEPS is how often, from 1 on, not -3");
  EXPECT_EQ(s.refusal("redo 0"), "redo: STEPS is how often, from 1 on, not 0");
  EXPECT_EQ(s.refusal("undo 1e12"), "undo: STEPS expects an integer of at most 2147483647, not '1e12'");
  EXPECT_EQ(s.refusal("setAttr x.weights[2000000000] 1"),
            "x: 'weights[2000000000]' has too large a number: the last element there can be is [1000000000]");
  EXPECT_EQ(s.refusal("setAttr x.weights[99999999999999] 1"),
            "x: 'weights[99999999999999]' has too large a number: the last element there can be is "
            "[1000000000]");
}

TEST_F(BadCommand, AddedAttributesSayWhatIsWrongWithThem) {
  EXPECT_EQ(
      s.refusal("addAttr e z -type tensor"),
      "addAttr: unknown attribute type 'tensor'; there are: bool, int, float, double, enum, string, "
      "path, float2, float3, float4, colour, matrix, distance, angle, time, node, ramp, compound, data");
  EXPECT_EQ(s.refusal("addAttr e z -type flaot"),
            "addAttr: unknown attribute type 'flaot' (did you mean 'float'?)");
  EXPECT_EQ(s.refusal("addAttr e 2z"),
            "addAttr: '2z' cannot name an attribute: a letter or _, then letters, digits and _");
  EXPECT_EQ(s.refusal("addAttr e z -type enum"),
            "addAttr: an enum needs its choices: -choices off,low:10,high");
  EXPECT_EQ(s.refusal("addAttr e z -type data"),
            "addAttr: data need the type of what connects to it: -dataType NAME");
  EXPECT_EQ(s.refusal("addAttr e z -min 2 -max 1"), "addAttr: -min 2 lies above -max 1");
  EXPECT_EQ(s.refusal("addAttr e z -default soft"), "addAttr: -default expects a number, not 'soft'");
  EXPECT_EQ(s.refusal("addAttr e z -max 1 -default 4"),
            "addAttr: -default 4 is out of its range (a number <= 1)");
  EXPECT_EQ(s.refusal("addAttr e weight"), "addAttr: e has an attribute 'weight' already");
}

TEST_F(BadCommand, WhatDrivesNothingCannotBeDisconnected) {
  EXPECT_EQ(s.refusal("disconnectAttr x.vector y.a"),
            "disconnectAttr: x.vector does not drive y.a, which is driven by x.out");
  EXPECT_EQ(s.refusal("disconnectAttr x.out x.b"),
            "disconnectAttr: x.out does not drive x.b, nor does anything else");
  s.run("disconnectAttr x.out y.a");
  EXPECT_EQ(s.run("listConnections y"), "");
}

TEST_F(BadCommand, KeysAreValuesThatTheAttributeCanHave) {
  EXPECT_EQ(s.refusal("setKeyframe e.mode -value medium"),
            "setKeyframe: e.mode 'medium' is none of off (0), low (10), high (30)");
  EXPECT_EQ(s.refusal("setKeyframe e.mode -value 7"),
            "setKeyframe: e.mode '7' is none of off (0), low (10), high (30)");
  s.run("setKeyframe e.mode -time 1 -value high\nsetKeyframe e.mode -time 5 -value 10");
  EXPECT_EQ(s.run("getAttr e.mode -time 1\ngetAttr e.mode -time 5"), "high\nlow");
  s.run("setKeyframe e.size -time 1 -value 35mm");
  EXPECT_EQ(s.run("getAttr e.size -time 1"), "0.035");
  EXPECT_EQ(s.refusal("setKeyframe e.axis -value 1,2"), "setKeyframe: e.axis.x expects a number, not '1,2'");
  s.warnings.clear();
  s.run("setKeyframe e.weight -time 1 -value 3");
  EXPECT_EQ(s.run("getAttr e.weight -time 1"), "1");
  EXPECT_EQ(s.warnings, std::vector<std::string>{
                            "e.weight is out of its range (a number from 0 to 1) and is keyed at 1"});
}

TEST_F(BadCommand, ASceneIsSavedUnderANameThatIsOne) {
  EXPECT_EQ(s.refusal("save /tmp/shot.vdb"), "save: /tmp/shot.vdb: the name of a scene ends in .plinian");
  EXPECT_EQ(s.refusal("export /tmp/shot.abc x"),
            "export: /tmp/shot.abc: the name of a scene ends in .plinian");
  EXPECT_EQ(s.refusal("save /tmp"), "save: /tmp: is a folder: name a file in it");
  EXPECT_EQ(s.refusal("export nowhere/ x"), "export: nowhere/: is a folder: name a file in it");
  EXPECT_EQ(s.refusal("import x.plinian -merge"),
            "import: -merge says what becomes of -namespace, which is not given");
}

}  // namespace
}  // namespace plinian::graph
