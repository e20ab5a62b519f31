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

TEST(TransformNode, NamesThatMayaHasForItsPartsAreUnderstood) {
  NodeSession s;
  s.run("createNode transform -name t");
  for (const auto& [name, meant] :
       {std::pair("translateX", "translate.x"), {"ry", "rotate.y"}, {"sz", "scale.z"}})
    EXPECT_EQ(
        s.refusal(std::string("setAttr t.") + name + " 1"),
        std::string("node 't' (transform) has no attribute '") + name + "' (did you mean '" + meant + "'?)");
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

TEST(TransformNode, AVectorIsKeyedAtOnce) {
  NodeSession s;
  s.run("createNode transform -name t\nsetKeyframe t.translate -time 1 -value 1 -2 3.5");
  EXPECT_EQ(s.run("getAttr t.translate"), "translate.x 1\ntranslate.y -2\ntranslate.z 3.5");
  s.run("setKeyframe t.translate -value \"4 5 6\" -time 1");
  EXPECT_EQ(s.run("getAttr t.translate"), "translate.x 4\ntranslate.y 5\ntranslate.z 6");
  EXPECT_EQ(s.refusal("setKeyframe t.translate -value 1 2"),
            "setKeyframe: -value: t.translate is keyed by 3 numbers, not by 2");
  EXPECT_EQ(s.refusal("setKeyframe t.rotate.y -value 1 2"),
            "setKeyframe: -value: t.rotate.y is keyed by 1 number, not by 2");
  EXPECT_EQ(s.refusal("setKeyframe t.rotate.y -value \"\""), "setKeyframe: -value is empty");
  std::string echo;
  s.on_echo = [&](const std::string& line) { echo = line; };
  s.run("setKeyframe -value 7 8 9 t.translate -time 2");
  EXPECT_EQ(echo, "setKeyframe -time 2 -value 7 8 9 t.translate") << "runs again as it ran";
}

}  // namespace
}  // namespace plinian
