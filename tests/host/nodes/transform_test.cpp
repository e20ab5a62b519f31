#include "tests/host/nodes/node_session.h"

namespace plinian {
namespace {

TEST(TransformNode, ItsMatrixScalesTurnsAndMoves) {
  NodeSession s;
  s.run(
      "createNode transform -name t\nsetAttr t.translate 10 0 0\nsetAttr t.rotate 0 0 90\nsetAttr t.scale 2 "
      "1 1");
  EXPECT_EQ(s.run("getAttr t.matrix"), "0 2 0 0 -1 0 0 0 0 0 1 0 10 0 0 1");
  EXPECT_EQ(s.run("getAttr t.inverse_matrix"), "0 -1 0 0 0.5 0 0 0 0 0 1 0 0 10 0 1");
  EXPECT_EQ(s.run("setAttr t.translate.x 250cm\ngetAttr t.translate"),
            "translate.x 2.5\ntranslate.y 0\ntranslate.z 0");
}

TEST(TransformNode, AScaleOfZeroHasNoInverseAndSaysSo) {
  NodeSession s;
  s.run("createNode transform -name t\nsetAttr t.scale.y 0");
  EXPECT_EQ(s.refusal("getAttr t.inverse_matrix"), "t.inverse_matrix: a scale of 0 cannot be undone");
  EXPECT_EQ(s.refusal("setAttr t.translate 1 2"), "t.translate expects 3 values, one for each of its parts");
}

TEST(TransformNode, ItsPartsAreKeyedTogether) {
  NodeSession s;
  s.run(
      "createNode transform -name t\nsetKeyframe t.translate -time 1 -value 0\n"
      "setKeyframe t.translate -time 11 -value 10 -interpolation linear");
  EXPECT_EQ(s.run("ls -type animCurve"), "t_translate_x\nt_translate_y\nt_translate_z");
  EXPECT_EQ(s.run("currentTime 11\ngetAttr t.translate"),
            "11\ntranslate.x 10\ntranslate.y 10\ntranslate.z 10");
}

}  // namespace
}  // namespace plinian
