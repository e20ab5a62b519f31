// Things that are taken hold of in the viewport, by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/host/window/steps.h"

namespace plinian {
namespace {

constexpr ivec2 size(1280, 800);

// A white ball of radius 1 around the origin, seen from (0, 0, 6) with 40 degrees from top to bottom.
constexpr const char* scene = R"({"volume": "sphere", "density_scale": 40.0, "size": [640, 480],
  "camera": {"eye": [0, 0, 6], "target": [0, 0, 0], "fov_y_degrees": 40},
  "lights": [{"name": "key", "type": "directional", "toward": [0.3, 0.5, 1], "irradiance": [9, 9, 9]}]})";

class HandlesSitting : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
    sitting_ = std::make_unique<Sitting>(std::vector<std::string>{files_.write("ball.json", scene)}, size);
    wait_for_rest(0);
  }
  void wait_for_rest(std::size_t since) { plinian::wait_for_rest(*sitting_, since); }
  void command(const std::string& line) {
    const std::size_t before = sitting_->now();
    plinian::command(*sitting_, line);
    // With what was typed done, the field lets go of the keys and takes them again.
    sitting_->wait_for("keys to a field",
                       sitting_->wait_for("ran " + line.substr(0, line.find(' ')), before));
    leave_fields(*sitting_, {700, size.y - 6});  // into the status line
  }
  /// The scene as it would be saved.
  std::string saved() {
    command("save now.plinian");
    return text_of(sitting_->folder() / "now.plinian");
  }
  /// A number that is not at its default; none where it is.
  static std::optional<double> number(const std::string& scene, const std::string& node,
                                      const std::string& attribute) {
    std::istringstream lines(scene);
    std::string line, in, word;
    while (std::getline(lines, line)) {
      std::istringstream words(line);
      words >> word;
      if (word == "node") {
        words >> word >> in;
      } else if (in == node && word == "." + attribute) {
        double value = 0.0;
        words >> value;
        return value;
      }
    }
    return std::nullopt;
  }
  void use(const char* key) {
    const std::size_t before = sitting_->now();
    sitting_->stroke(key);
    sitting_->wait_for(" still", before);
  }
  /// Middle of what is bright in the picture. [points] from its left
  double brightness_middle() {
    const ivec4 place = sitting_->item("picture");
    const Pixels seen = sitting_->pixels(place);
    double sum = 0.0, moment = 0.0;
    for (int i = 0; i < seen.width * seen.height; ++i)
      if (const int green = seen.rgb[3 * std::size_t(i) + 1]; green > 90) {
        sum += 1.0;
        moment += i % seen.width;
      }
    return moment / sum;
  }
  /// How many commands of the trace hold these words, from a line on.
  int count(const std::string& words, std::size_t since) {
    int found = 0;
    for (std::size_t i = since; i < sitting_->lines().size(); ++i)
      found += sitting_->line(i).find(words) != std::string::npos;
    return found;
  }

  TemporaryFolder files_;
  std::unique_ptr<Sitting> sitting_;
};

TEST_F(HandlesSitting, AnArrowMovesAVolumeAlongItAloneAndUndoTakesTheWholeDragBack) {
  Sitting& sitting = *sitting_;
  std::size_t before = sitting.now();
  sitting.click(sitting.middle("picture"));
  sitting.wait_for(" still", sitting.wait_for("select medium_shape", before));
  const std::string first = saved();
  use("w");
  const double middle = brightness_middle();
  sitting_->keep("handles-1-translate.png");
  before = sitting.now();
  const ivec2 grip = sitting.middle("handle x");
  sitting.move(grip);
  sitting.wait_for_mouse(grip, 0);
  sitting.press();
  sitting.wait_for_mouse(grip, 1);
  for (int i = 1; i <= 10; ++i) sitting.move(grip + ivec2(9 * i, 2 * i));
  sitting.wait_for_mouse(grip + ivec2(90, 20), 1);
  sitting.wait_for("setAttr medium_place.translate.x", before);
  sitting_->keep("handles-2-dragged.png");
  sitting.release();
  wait_for_rest(before);
  EXPECT_EQ(count("select", before), 0) << "a press on a handle selects nothing";
  // 6 m away the picture is 2 * 6 * tan(20 degrees) high.
  const double point = 12.0 * std::tan(20.0 * 3.14159265358979 / 180.0) / sitting.item("picture").w;
  EXPECT_NEAR(brightness_middle() - middle, 90.0, 6.0) << "the medium follows the mouse";
  const std::string moved = saved();
  const auto x = number(moved, "medium_place", "translate.x");
  ASSERT_TRUE(x) << moved;
  EXPECT_NEAR(*x, 90.0 * point, 1.5 * point);
  EXPECT_FALSE(number(moved, "medium_place", "translate.y"));
  EXPECT_FALSE(number(moved, "medium_place", "translate.z"));
  before = sitting.now();
  sitting.stroke("Control_L+z");
  wait_for_rest(sitting.wait_for("ran undo", before));
  EXPECT_EQ(saved(), first);
  EXPECT_NEAR(brightness_middle(), middle, 1.0);
}

TEST_F(HandlesSitting, RingsTurnTheKeyBoxesScaleAndEscapeTakesBack) {
  Sitting& sitting = *sitting_;
  command("select key");
  const std::string first = saved();
  use("e");
  sitting_->keep("handles-3-rotate.png");
  std::size_t before = sitting.now();
  ivec2 grip = sitting.middle("handle view");
  sitting.drag(grip, grip + ivec2(-30, 40));
  sitting.wait_for("setAttr key.rotate", before);
  const std::string turned = saved();
  EXPECT_NE(turned, first);
  EXPECT_EQ(count("setAttr key.translate", before), 0);
  sitting.stroke("Control_L+z");
  EXPECT_EQ(saved(), first);

  command("select medium_place");
  use("r");
  sitting_->keep("handles-4-scale.png");
  before = sitting.now();
  grip = sitting.middle("handle y");
  sitting.drag(grip, grip + ivec2(0, -40));
  sitting.wait_for("setAttr medium_place.scale.y", before);
  const std::string scaled = saved();
  EXPECT_GT(number(scaled, "medium_place", "scale.y").value_or(0.0), 1.2);
  EXPECT_FALSE(number(scaled, "medium_place", "scale.x"));
  sitting.stroke("Control_L+z");
  EXPECT_EQ(saved(), first);

  // Taken back while it is held; what the mouse does then, until it is let go, does nothing.
  before = sitting.now();
  grip = sitting.middle("handle centre");
  sitting.move(grip);
  sitting.wait_for_mouse(grip, 0);
  sitting.press();
  sitting.wait_for_mouse(grip, 1);
  for (int i = 1; i <= 6; ++i) sitting.move(grip + ivec2(12 * i, 0));
  sitting.wait_for("setAttr medium_place.scale", before);
  const std::size_t held = sitting.now();
  sitting.stroke("Escape");
  sitting.wait_for("ran undo", held);
  const std::size_t taken_back = sitting.now();
  sitting.move(grip + ivec2(150, 0));
  sitting.wait_for_mouse(grip + ivec2(150, 0), 1);
  sitting.release();
  sitting.wait_for_mouse(grip + ivec2(150, 0), 0);
  EXPECT_EQ(count("setAttr", taken_back), 0);
  EXPECT_EQ(saved(), first);
}

TEST_F(HandlesSitting, WhatIsLockedStaysAndSaysWhy) {
  Sitting& sitting = *sitting_;
  command("lockAttr medium_place.translate.x");
  command("select medium_place");
  const std::string first = saved();
  use("w");
  sitting_->keep("handles-5-locked.png");
  std::size_t before = sitting.now();
  ivec2 grip = sitting.middle("handle x");
  sitting.drag(grip, grip + ivec2(60, 0));
  sitting.wait_for("medium_place.translate.x is locked", before);
  sitting.wait_for(" still", before);
  sitting_->keep("handles-6-refused.png");
  EXPECT_EQ(count("setAttr", before), 0);
  before = sitting.now();
  grip = sitting.middle("handle y");
  sitting.drag(grip, grip + ivec2(0, -40));
  sitting.wait_for("setAttr medium_place.translate.y", before);
  EXPECT_TRUE(number(saved(), "medium_place", "translate.y"));
  use("q");
  before = sitting.now();
  sitting.drag(grip, grip + ivec2(0, -40));
  sitting.wait_for_mouse(grip + ivec2(0, -40), 0);
  EXPECT_EQ(count("setAttr", before), 0) << "nothing to take hold of";
}

TEST_F(HandlesSitting, AHandleOfAPluginSetsItsAttributeInOneStep) {
  Sitting& sitting = *sitting_;
  command("loadPlugin \"" PLINIAN_WINDOW_PLUGINS "/lamp.so\"");
  command("createNode lampShape -name lamp");
  command("select lamp");
  const std::string first = saved();
  use("w");
  sitting_->keep("handles-7-plugin.png");
  std::size_t before = sitting.now();
  const ivec2 grip = sitting.middle("handle range");
  sitting.drag(grip, grip + ivec2(25, -50));
  sitting.wait_for("setAttr lamp.range", before);
  // Along its axis, which stands upright in the picture, 6 m away.
  const double point = 12.0 * std::tan(20.0 * 3.14159265358979 / 180.0) / sitting.item("picture").w;
  EXPECT_NEAR(number(saved(), "lamp", "range").value_or(0.0), 1.5 + 50.0 * point, 1.5 * point);
  sitting.stroke("Control_L+z");
  EXPECT_EQ(saved(), first);
}

}  // namespace
}  // namespace plinian
