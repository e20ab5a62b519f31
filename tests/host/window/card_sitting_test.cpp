// What a plug-in draws by the light maps of the picture, how it fails, and what is left of it.
#include <csignal>
#include <fstream>

#include "core/scene/camera.h"
#include "tests/host/window/drawing_sitting.h"

namespace plinian {
namespace {

// The card lies under the ball, which the light shines on from above.
constexpr const char* scene_from_above = R"({"volume": "sphere", "density_scale": 40.0, "size": [640, 480],
  "camera": {"eye": [0, 4, 6], "target": [0, 0, 0], "fov_y_degrees": 40},
  "lights": [{"type": "directional", "toward": [0, 1, 0], "irradiance": [9, 9, 9]}]})";

class CardSitting : public DrawingSitting {
 protected:
  void SetUp() override {
    DrawingSitting::SetUp();
    if (IsSkipped()) return;
    setenv("PLINIAN_CARD_LOG", (files_ / "log").c_str(), 1);
    sit_down("card", scene_from_above);
    command("createNode card");
    command("select -clear");
  }
  void TearDown() override { unsetenv("PLINIAN_CARD_LOG"); }
  /// Where a point of the world is seen.
  ivec2 point(const dvec3& world) {
    const CameraRays rays = camera_rays(look_at({0, 4, 6}, {0, 0, 0}, {0, 1, 0}, 40.0), 640, 480);
    const dvec3 lens = glm::inverse(dmat3(dvec3(rays.right), dvec3(rays.up), dvec3(rays.forward))) *
                       (world - dvec3(rays.origin));
    const ivec4 place = sitting_->item("picture");
    return {place.x + int((0.5 + 0.5 * lens.x / lens.z) * place.z),
            place.y + int((0.5 - 0.5 * lens.y / lens.z) * place.w)};
  }
  /// What is seen there.
  std::array<int, 3> seen(const dvec3& world) {
    const ivec2 at = point(world);
    const Pixels pixel = sitting_->pixels({at.x, at.y, 1, 1});
    return {pixel.rgb[0], pixel.rgb[1], pixel.rgb[2]};
  }
  int noted(const std::string& word) {
    std::ifstream file(files_ / "log");
    int count = 0;
    for (std::string line; std::getline(file, line);) count += line == word;
    return count;
  }

  static constexpr dvec3 below{0.32, -1.2, 0.71}, beside{1.8, -1.2, 1.1};  // the ball, on the card
};

TEST_F(CardSitting, ItsShaderSeesTheShadowsOfThePicture) {
  sitting_->keep("card-1-from-above.png");
  EXPECT_LT(seen(below)[0], 20) << "in the shadow";
  EXPECT_GT(seen(below)[1], 235);
  EXPECT_GT(seen(beside)[0], 235) << "in the light";
  EXPECT_LT(seen(beside)[1], 20);
  const auto on_the_ball = seen({0.0, 0.8, 0.6});
  EXPECT_EQ(on_the_ball[0], on_the_ball[1]) << "which hides the card";
  // From the side the light passes under the ball.
  std::size_t since = sitting_->now();
  command("setAttr light0.rotate 0 90 0");
  wait_for_rest(since);
  sitting_->keep("card-2-from-the-side.png");
  EXPECT_GT(seen(below)[0], 235);
  since = sitting_->now();
  command("undo");
  wait_for_rest(since);
  EXPECT_LT(seen(below)[0], 20);
  // Another power of the light is another picture of the same maps.
  command("setAttr light0.exposure -1");
  EXPECT_LT(seen(below)[0], 20);
  EXPECT_GT(seen(beside)[0], 235);
}

// Its override has no hit function.
TEST_F(CardSitting, AClickOnWhatIsDrawnSelectsIt) {
  const auto selected_by = [&](const dvec3& world) {
    const std::size_t before = sitting_->now();
    sitting_->click(point(world));
    const std::string line = sitting_->line(sitting_->wait_for("ran select ", before));
    return line.substr(line.find("select "), line.find(" (") - line.find("select "));
  };
  EXPECT_EQ(selected_by(beside), "select card1");
  EXPECT_EQ(selected_by({0.0, 0.8, 0.6}), "select medium_shape") << "the card goes on behind it";
  EXPECT_EQ(selected_by(below), "select card1");
  EXPECT_EQ(selected_by({0.0, 2.2, -1.0}), "select -clear") << "above both";
}

TEST_F(CardSitting, WhatFailsIsToldOnceAndLeavesThePicture) {
  const auto ball = seen({0.0, 0.8, 0.6});
  EXPECT_GT(ball[0], 30);
  const auto told = [&](const std::string& what) {
    int count = 0;
    for (const std::string& line : sitting_->lines()) count += line.find("told card1: " + what) != line.npos;
    return count;
  };
  command("setAttr card1.fault draw");
  EXPECT_EQ(told("draw failed: out of ink"), 1);
  EXPECT_EQ(seen(below), (std::array<int, 3>{0, 0, 0})) << "nothing but the background";
  EXPECT_EQ(seen({0.0, 0.8, 0.6}), ball);
  command("setAttr card1.height -1.3");
  EXPECT_EQ(told("draw failed: out of ink"), 1) << "the same cause";
  // One that paints over everything and makes an error of GL.
  command("setAttr card1.fault error");
  EXPECT_EQ(told("draw failed: it left the GL error 0x0500"), 1);
  sitting_->keep("card-3-failed.png");
  EXPECT_EQ(seen({0.0, 0.8, 0.6}), ball);
  EXPECT_EQ(seen(below), (std::array<int, 3>{0, 0, 0}));
  command("resetAttr card1.fault");
  EXPECT_GT(seen(below)[1], 235);
  command("setAttr card1.fault prepare");
  EXPECT_EQ(told("prepare failed: out of paper"), 1);
  EXPECT_GT(seen(below)[1], 235) << "the last good one";
}

TEST_F(CardSitting, WhatItMadeIsLetGoOfWithItsPluginAndAtTheEnd) {
  EXPECT_EQ(noted("upload"), 1);
  command("setAttr card1.height -1.3");
  EXPECT_EQ(noted("upload"), 2);
  EXPECT_EQ(noted("release"), 1);
  command("unloadPlugin -force card");
  EXPECT_EQ(noted("release"), 2);
  command("loadPlugin \"" PLINIAN_TEST_PLUGINS "/card.so\"");
  command("delete card1");
  EXPECT_EQ(noted("upload"), noted("release"));
  command("undo");
  EXPECT_EQ(noted("upload"), 4);
  EXPECT_EQ(noted("release"), 3);
  sitting_->send(SIGTERM);
  EXPECT_EQ(sitting_->exit_code(), 130) << "it was told to end";
  EXPECT_EQ(noted("release"), 4);
  EXPECT_EQ(noted("lost"), 0);
  EXPECT_EQ(sitting_->errors(), "");
}

}  // namespace
}  // namespace plinian
