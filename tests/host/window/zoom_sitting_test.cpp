// A close look at pixels, by hand: the wheel, a drag, the badge, and the picture that stays as it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "tests/host/window/steps.h"

namespace plinian {
namespace {

class ZoomSitting : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string problem = Sitting::problem(); !problem.empty()) GTEST_SKIP() << problem;
  }
  void wheel(Sitting& sitting, int notches) {
    for (int i = 0; i < std::abs(notches); ++i) {
      sitting.press(notches > 0 ? 4 : 5);
      sitting.release(notches > 0 ? 4 : 5);
    }
  }
  /// With Z held, at a place; waits until it is on the screen.
  void zoom(Sitting& sitting, ivec2 at, int notches, const std::string& to) {
    sitting.move(at);
    sitting.wait_for_mouse(at, 0);
    const std::size_t before = sitting.now();
    sitting.key_down("z");
    wheel(sitting, notches);
    sitting.wait_for(" still", sitting.wait_for(" zoom " + to, before));
    sitting.key_up("z");
  }
  /// Takes the mouse off the picture, and waits until that is on the screen.
  void look_away(Sitting& sitting) {
    const std::size_t before = sitting.now();
    sitting.move({5, 5});
    sitting.wait_for(" still", sitting.wait_for(" mouse 5 5 0", before));
  }
  static std::array<int, 3> colour(const Pixels& seen, ivec2 at) {
    const std::uint8_t* rgb = seen.rgb.data() + 3 * (std::size_t(at.y) * seen.width + std::size_t(at.x));
    return {rgb[0], rgb[1], rgb[2]};
  }
};

TEST_F(ZoomSitting, PixelsAreSeenAsSquaresWhereTheyAreAndNothingElseMoves) {
  constexpr ivec2 size(1000, 700);
  Sitting sitting({"sphere"}, size);
  wait_for_rest(sitting, 0);
  look_away(sitting);
  sitting.keep("zoom-1-whole.png");
  const ivec4 whole = sitting.item("picture");
  const Pixels before = sitting.pixels(whole);
  const std::size_t began = sitting.now();
  const ivec2 at(whole.x + 11 * whole.z / 20, whole.y + 9 * whole.w / 20);  // on the ball
  zoom(sitting, at, 4, "4x");
  sitting.keep("zoom-2-4x.png");
  const ivec4 picture = sitting.item("picture");
  EXPECT_EQ(picture.z, 4 * whole.z);
  EXPECT_NEAR(double(at.x - picture.x) / picture.z, double(at.x - whole.x) / whole.z, 1.0 / whole.z);
  EXPECT_NEAR(double(at.y - picture.y) / picture.w, double(at.y - whole.y) / whole.w, 1.0 / whole.w);
  look_away(sitting);  // the pixel under the pointer has an edge
  // Every pixel around the pointer is the square that it was, but for a row that the sides were rounded by.
  const Pixels seen = sitting.pixels({at.x - 24, at.y - 24, 49, 49});
  int differ = 0;
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      const vec2 share((float(at.x - 24 + x - picture.x) + 0.5f) / float(picture.z),
                       (float(at.y - 24 + y - picture.y) + 0.5f) / float(picture.w));
      differ += colour(seen, {x, y}) != colour(before, ivec2(share * vec2(before.width, before.height)));
    }
  EXPECT_EQ(differ, 0);

  // The hand takes it along, Z or not by the end.
  sitting.key_down("z");
  sitting.drag(at, at + ivec2(-60, 35));
  sitting.key_up("z");
  look_away(sitting);
  const ivec4 panned = sitting.item("picture");
  EXPECT_NEAR(panned.x, picture.x - 60, 1);
  EXPECT_NEAR(panned.y, picture.y + 35, 1);
  zoom(sitting, at, 4, "16x");
  sitting.keep("zoom-3-16x.png");
  for (std::size_t i = began; i < sitting.now(); ++i) {
    EXPECT_EQ(sitting.line(i).find(" ran "), std::string::npos) << "no edit: " << sitting.line(i);
    EXPECT_EQ(sitting.line(i).find(" picture "), std::string::npos) << "rendered: " << sitting.line(i);
  }

  std::size_t since = sitting.now();
  sitting.click(at);
  sitting.wait_for("ran select medium_shape", since);
  since = sitting.now();
  sitting.stroke("Control_L+z");
  sitting.wait_for("ran undo", since);
  since = sitting.now();
  sitting.click(sitting.middle("zoom badge"));
  sitting.move({5, 5});
  sitting.wait_for(" still", sitting.wait_for("item \"picture\"", since));
  EXPECT_EQ(sitting.item("picture"), whole);
  sitting.keep("zoom-4-whole-again.png");

  // By keys about the pointer, and what frames anew shows all of it.
  since = sitting.now();
  sitting.move(at);
  sitting.wait_for_mouse(at, 0);
  sitting.stroke("equal");
  sitting.stroke("equal");
  sitting.wait_for(" zoom 2x", since);
  since = sitting.now();
  sitting.stroke("Shift_L+z");
  sitting.wait_for("item \"picture\"", since);
  EXPECT_EQ(sitting.item("picture"), whole);
}

// As it would be done with an edge that looks different: close up, with the line between the two.
TEST_F(ZoomSitting, WhatIsComparedIsMagnifiedAlike) {
  constexpr ivec2 size(1000, 700);
  Sitting sitting({"sphere"}, size);
  wait_for_rest(sitting, 0);
  std::size_t since = sitting.now();
  sitting.stroke("p");
  sitting.wait_for("psnr", since);
  const ivec4 whole = sitting.item("picture");
  const ivec2 middle(whole.x + whole.z / 2, whole.y + whole.w / 2);
  sitting.stroke("Shift_L+s");
  sitting.wait_for(" still", sitting.wait_for("item \"picture\"", since));
  const ivec4 left = sitting.item("picture");
  EXPECT_LT(left.z, whole.z);
  const ivec2 edge(left.x + left.z / 3, left.y + left.w / 3);
  zoom(sitting, edge, 6, "8x");
  look_away(sitting);
  sitting.keep("zoom-5-side-by-side.png");
  // Both halves show the same pixels.
  const int step = sitting.item("other picture").x - sitting.item("picture").x;
  EXPECT_GT(step, 0);
  const ivec4 part{edge.x - 30, edge.y - 30, 60, 60};
  const Pixels a = sitting.pixels(part), b = sitting.pixels({part.x + step, part.y, part.z, part.w});
  int differ = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) differ += std::abs(int(a.rgb[i]) - int(b.rgb[i])) > 1;
  EXPECT_EQ(differ, 0);
  EXPECT_GT(*std::max_element(a.rgb.begin(), a.rgb.end()), 40) << "something is seen";

  // The wipe's line stays within reach.
  since = sitting.now();
  sitting.stroke("Shift_L+w");
  sitting.wait_for(" still", sitting.wait_for("item \"wipe line\"", since));
  sitting.keep("zoom-6-wipe.png");
  const ivec2 line = sitting.middle("wipe line");
  EXPECT_GT(line.x, whole.x);
  EXPECT_LT(line.x, whole.x + whole.z);
  sitting.drag(line, {middle.x + 20, line.y});
  sitting.move({5, 5});
  EXPECT_NEAR(sitting.middle("wipe line").x, middle.x + 20, 2);
}

}  // namespace
}  // namespace plinian
