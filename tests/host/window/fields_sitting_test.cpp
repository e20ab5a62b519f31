// Fields of the attribute editor and of the light list that are more than a number.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <sstream>

#include "tests/host/window/steps.h"

namespace plinian {
namespace {

class FieldsSitting : public testing::Test {
 protected:
  static constexpr ivec2 size{1280, 700};

  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
    sitting_ = std::make_unique<Sitting>(std::vector<std::string>{"sphere"}, size);
    wait_for_rest(*sitting_, 0);
  }
  std::string saved(const std::string& name) {
    command(*sitting_, "save " + name);
    leave_fields(*sitting_, {640, 694});
    return text_of(sitting_->folder() / name);
  }
  /// Clicks, and returns where the item is that comes of it.
  ivec4 opened(const std::string& by, const std::string& item) {
    const std::size_t before = sitting_->now();
    sitting_->click(sitting_->middle(by));
    sitting_->wait_for("item \"" + item + "\"", before);
    sitting_->wait_for(" still", sitting_->now());
    return sitting_->item(item);
  }
  void expect_within(ivec4 place) {
    EXPECT_GE(place.x, 0);
    EXPECT_GE(place.y, 0);
    EXPECT_LE(place.x + place.z, size.x);
    EXPECT_LE(place.y + place.w, size.y);
  }
  /// The numbers behind the last command that begins so.
  std::vector<double> last(const std::string& command) {
    std::vector<double> numbers;
    for (const std::string& line : sitting_->lines())
      if (const std::size_t at = line.find("ran " + command + " "); at != line.npos) {
        std::istringstream words(line.substr(at + 4 + command.size()));
        numbers.clear();
        for (double number; words >> number;) numbers.push_back(number);
      }
    return numbers;
  }
  void select(const std::string& node) {
    const std::size_t before = sitting_->now();
    sitting_->click(sitting_->middle("node " + node));
    sitting_->wait_for("ran select " + node, before);
    sitting_->move({640, 694});
    sitting_->wait_for(" still", sitting_->now());
  }
  void wait_and_keep(const std::string& name) {
    sitting_->wait_for(" still", sitting_->now() - 1);
    sitting_->keep(name);
  }

  std::unique_ptr<Sitting> sitting_;
};

TEST_F(FieldsSitting, TheColourPickerOpensBesideItsRowAndEscapeTakesItBack) {
  const std::string original = saved("original.plinian");
  const ivec4 field = sitting_->item("medium.albedo.b");
  const ivec4 picker = opened("medium.albedo swatch", "picker");
  expect_within(picker);
  EXPECT_LE(picker.x + picker.z, sitting_->item("medium.density_scale").x - 100)
      << "over the picture, not over the fields";
  EXPECT_LE(picker.y, field.y + field.w);
  wait_and_keep("colour-1-albedo.png");

  // The hand goes from grey to a red; the fields follow, and the ranges of the albedo hold.
  const ivec4 square = sitting_->item("picker square");
  std::size_t before = sitting_->now();
  sitting_->drag({square.x + 4, square.y + 40}, {square.x + square.z * 3 / 4, square.y - 30});
  sitting_->wait_for("ran setAttr medium.albedo 1 ", before);
  std::vector<double> albedo = last("setAttr medium.albedo");
  ASSERT_EQ(albedo.size(), 3u);
  EXPECT_EQ(albedo[0], 1.0) << "no more than all light is scattered";
  EXPECT_NEAR(albedo[1], std::pow((0.25 + 0.055) / 1.055, 2.4), 0.006) << "a quarter of the display's value";
  EXPECT_EQ(albedo[1], albedo[2]);
  wait_and_keep("colour-2-dragged.png");
  before = sitting_->now();
  sitting_->drag(sitting_->middle("picker hue"), sitting_->middle("picker hue") + ivec2(0, 20));
  sitting_->wait_for("ran setAttr medium.albedo ", before);
  EXPECT_GT(last("setAttr medium.albedo")[2], last("setAttr medium.albedo")[0]) << "it is a blue now";

  // A number is typed; Escape leaves the field first.
  sitting_->click(sitting_->middle("picker R"));
  sitting_->wait_for_keys("keys to a field");
  before = sitting_->now();
  sitting_->stroke("Control_L+a");
  sitting_->type("0.5");
  sitting_->stroke("Return");
  sitting_->wait_for("ran setAttr medium.albedo 0.5 ", before);
  sitting_->wait_for_keys("keys to the window");
  sitting_->click(sitting_->middle("picker G"));
  sitting_->wait_for_keys("keys to a field");
  sitting_->type("9");
  sitting_->stroke("Escape");
  sitting_->wait_for_keys("keys to the window");
  wait_and_keep("colour-3-typed.png");
  before = sitting_->now();
  sitting_->stroke("Escape");
  sitting_->wait_for("ran undo", before);
  EXPECT_EQ(saved("taken-back.plinian"), original);

  // What was done in there is one step of undo.
  opened("medium.albedo swatch", "picker");
  for (const int share : {2, 3}) {
    before = sitting_->now();
    sitting_->drag({square.x + 4, square.y + 40}, {square.x + square.z / share, square.y + 60});
    sitting_->wait_for("ran setAttr medium.albedo ", before);
  }
  leave_fields(*sitting_, {640, 694});
  sitting_->wait_for(" still", sitting_->now());
  EXPECT_NE(saved("dragged.plinian"), original);
  before = sitting_->now();
  sitting_->stroke("Control_L+z");
  sitting_->wait_for("ran undo", before);
  EXPECT_EQ(saved("undone.plinian"), original);
}

TEST_F(FieldsSitting, TheLightListChoosesColoursBrighterThanADisplay) {
  command(*sitting_, "setAttr key.colour 4 2 1");
  leave_fields(*sitting_, {640, 694});
  const ivec4 picker = opened("key.colour swatch", "picker");
  expect_within(picker);
  const ivec4 exposure = sitting_->item("light key exposure");
  EXPECT_GE(picker.x, exposure.x + exposure.z) << "beside the list";
  wait_and_keep("colour-4-light.png");
  // Without its saturation it is as bright.
  const ivec4 square = sitting_->item("picker square");
  std::size_t before = sitting_->now();
  sitting_->drag({square.x + square.z / 2, square.y + 10}, {square.x - 20, square.y - 20});
  sitting_->wait_for("ran setAttr key.colour 4 4 4", before);
  sitting_->click(sitting_->middle("picker before"));
  sitting_->wait_for("ran setAttr key.colour 4 2 1", before);
  wait_and_keep("colour-5-before.png");
}

TEST_F(FieldsSitting, ALightIsPlacedByAzimuthAndElevation) {
  select("key");
  const std::string original = saved("original.plinian");
  const ivec4 azimuth = sitting_->item("key azimuth"), rotate = sitting_->item("key.rotate");
  EXPECT_GT(azimuth.y, rotate.y);
  EXPECT_LT(azimuth.y, sitting_->item("key.rotate_order").y);
  wait_and_keep("angles-1.png");

  // A drag is one step of undo, and echoed as what it sets.
  std::size_t before = sitting_->now();
  sitting_->drag(sitting_->middle("key azimuth"), sitting_->middle("key azimuth") + ivec2(-40, 0));
  sitting_->wait_for("ran setAttr key.rotate.y ", before);
  sitting_->wait_for(" still", sitting_->now() - 1);
  sitting_->keep("angles-2-dragged.png");
  EXPECT_NE(saved("dragged.plinian"), original);
  before = sitting_->now();
  sitting_->stroke("Control_L+z");
  sitting_->wait_for("ran undo", before);
  EXPECT_EQ(saved("undone.plinian"), original);

  // Typed, also as a change of what was there; 270 is 90 from the other side.
  const auto type = [&](const char* item, const char* text, const std::string& command) {
    sitting_->click(sitting_->middle(item));
    sitting_->wait_for_keys("keys to a field");
    const std::size_t before = sitting_->now();
    sitting_->stroke("Control_L+a");
    sitting_->type(text);
    sitting_->stroke("Return");
    sitting_->wait_for("ran " + command, before);
    sitting_->wait_for_keys("keys to the window");
  };
  type("key elevation", "35", "setAttr key.rotate.x -35");
  type("key azimuth", "20", "setAttr key.rotate.y 20");
  type("key azimuth", "+=30", "setAttr key.rotate.y 50");
  type("key azimuth", "270", "setAttr key.rotate.y -90");
  before = sitting_->now();
  type("key elevation", "200", "setAttr key.rotate.x -90");
  sitting_->wait_for("says key: an elevation of 200 is out of its range", before);
  wait_and_keep("angles-3-above.png");
  type("key elevation", "10", "setAttr key.rotate.x -10");

  // What is locked stays, and the other can be turned.
  command(*sitting_, "lockAttr key.rotate.y");
  leave_fields(*sitting_, {640, 694});
  before = sitting_->now();
  sitting_->drag(sitting_->middle("key azimuth"), sitting_->middle("key azimuth") + ivec2(60, 0));
  sitting_->move(sitting_->middle("key azimuth"));
  sitting_->wait_for_mouse(sitting_->middle("key azimuth"), 0);
  wait_and_keep("angles-4-locked.png");
  sitting_->drag(sitting_->middle("key elevation"), sitting_->middle("key elevation") + ivec2(60, 0));
  const std::size_t turned = sitting_->wait_for("ran setAttr key.rotate.x ", before);
  for (std::size_t i = before; i < turned; ++i)
    EXPECT_EQ(sitting_->line(i).find("ran "), std::string::npos) << sitting_->line(i);
}

}  // namespace
}  // namespace plinian
