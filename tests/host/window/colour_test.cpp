// What the colour picker makes of a colour, and where it opens.
#include <gtest/gtest.h>

#include "core/shared/view_curve.h"
#include "host/window/fields/hsv.h"
#include "host/window/panels/beside.h"

namespace plinian::window {
namespace {

void expect_colour(const vec3& a, const vec3& b, float tolerance = 1e-5f) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(Hsv, PureColoursHaveTheHuesOfTheWheel) {
  const std::pair<vec3, float> truths[] = {{{1, 0, 0}, 0.0f},   {{1, 1, 0}, 60.0f},  {{0, 1, 0}, 120.0f},
                                           {{0, 1, 1}, 180.0f}, {{0, 0, 1}, 240.0f}, {{1, 0, 1}, 300.0f}};
  for (const auto& [linear, hue] : truths) {
    const Hsv hsv = hsv_of(linear, {});
    EXPECT_NEAR(hsv.hue, hue, 1e-3);
    EXPECT_NEAR(hsv.saturation, 1.0, 1e-6);
    EXPECT_NEAR(hsv.value, 1.0, 1e-5);
    expect_colour(linear_of({hue, 1.0f, 1.0f}), linear);
  }
}

// Half of a display's value is far less than half of the light.
TEST(Hsv, AreThoseOfTheEncodedColour) {
  EXPECT_NEAR(hsv_of(vec3(0.18f), {}).value, 0.46136f, 1e-4);
  EXPECT_NEAR(linear_of({0.0f, 0.0f, 0.5f}).y, 0.214041f, 1e-5);
  const Hsv orange = hsv_of({1.0f, 0.214041f, 0.0f}, {});
  EXPECT_NEAR(orange.hue, 30.0f, 1e-2);
}

TEST(Hsv, WhatIsBrighterThanADisplayComesBackAsItWas) {
  const vec3 bright(8.0f, 3.0f, 0.5f);
  const Hsv hsv = hsv_of(bright, {});
  EXPECT_GT(hsv.value, 1.0f);
  expect_colour(linear_of(hsv), bright, 1e-4f);
  // Twice as saturated or not, the strongest channel stays.
  EXPECT_NEAR(linear_of({hsv.hue, 0.1f, hsv.value}).x, 8.0f, 1e-4);
}

TEST(Hsv, AGreyKeepsItsHueAndBlackItsSaturation) {
  const Hsv teal{190.0f, 0.7f, 0.5f};
  EXPECT_EQ(hsv_of(vec3(0.3f), teal).hue, 190.0f);
  EXPECT_EQ(hsv_of(vec3(0.3f), teal).saturation, 0.0f);
  const Hsv black = hsv_of(vec3(0.0f), teal);
  EXPECT_EQ(black.hue, 190.0f);
  EXPECT_EQ(black.saturation, 0.7f);
  EXPECT_EQ(black.value, 0.0f);
  EXPECT_EQ(hsv_of({-1.0f, 0.0f, 0.0f}, teal).value, 0.0f);
}

TEST(Hsv, AHueMayGoRoundAsOftenAsOneLikes) {
  expect_colour(linear_of({390.0f, 0.8f, 0.9f}), linear_of({30.0f, 0.8f, 0.9f}), 1e-4f);
  expect_colour(linear_of({-60.0f, 1.0f, 1.0f}), {1.0f, 0.0f, 1.0f});
}

TEST(Beside, OpensTowardsTheMiddleAndStaysInTheWindow) {
  const vec2 room(1280, 700), size(240, 330);
  const PaneRect left{{0, 400}, {230, 300}}, right{{930, 20}, {350, 680}};
  EXPECT_EQ(beside(right, 100.0f, size, room, 6.0f), vec2(684, 100));
  EXPECT_EQ(beside(left, 420.0f, size, room, 6.0f), vec2(236, 370)) << "as low as there is room";
  EXPECT_EQ(beside(right, -40.0f, size, room, 6.0f).y, 0.0f) << "the row is scrolled out of sight";
  EXPECT_EQ(beside({{100, 0}, {300, 300}}, 50.0f, size, {400, 300}, 6.0f), vec2(0, 0))
      << "over the pane rather than outside";
}

}  // namespace
}  // namespace plinian::window
