#include "core/scene/placement.h"

#include <gtest/gtest.h>

#include <random>

namespace plinian {
namespace {

dvec3 moved(const Placement& placement, const dvec3& point) {
  return dvec3(matrix_of(placement) * dvec4(point, 1.0));
}

TEST(Placement, ScalesThenTurnsThenMoves) {
  EXPECT_EQ(moved({.translate = {10, 0, 0}, .rotate = {0, 0, 90}, .scale = {2, 1, 1}}, {1, 0, 0}),
            dvec3(10, 2, 0));
}

TEST(Placement, QuarterTurnsAreExact) {
  for (const double turn : {90.0, -270.0, 450.0})
    EXPECT_EQ(moved({.rotate = {turn, 0, 0}}, {0, 1, 0}), dvec3(0, 0, 1)) << turn;
  EXPECT_EQ(moved({.rotate = {0, 180, 0}}, {1, 0, 2}), dvec3(-1, 0, -2));
}

TEST(Placement, TheFirstAxisOfTheOrderIsTurnedAboutFirst) {
  // x takes y to z, which z then leaves; z takes y to -x, which x then leaves.
  EXPECT_EQ(moved({.rotate = {90, 0, 90}, .order = RotateOrder::xyz}, {0, 1, 0}), dvec3(0, 0, 1));
  EXPECT_EQ(moved({.rotate = {90, 0, 90}, .order = RotateOrder::zyx}, {0, 1, 0}), dvec3(-1, 0, 0));
  EXPECT_EQ(rotate_order_names()[std::size_t(RotateOrder::zyx)], "zyx");
}

TEST(Placement, ThePivotStaysWhereItIs) {
  const Placement placement{
      .translate = {1, 2, 3}, .rotate = {20, 30, 40}, .scale = {2, 3, 4}, .pivot = {5, 6, 7}};
  EXPECT_NEAR(glm::length(moved(placement, {5, 6, 7}) - dvec3(6, 8, 10)), 0.0, 1e-12);
}

TEST(Placement, AnglesOfARotationMakeItAgain) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-400.0, 400.0);
  for (int i = 0; i < 1000; ++i) {
    dvec3 degrees(angle(random), angle(random), angle(random));
    if (i % 10 == 0) degrees.y = i % 20 ? 90.0 : -90.0;  // where x and z turn about the same line
    const dmat4 rotation = rotation_xyz(degrees), again = rotation_xyz(angles_of(rotation));
    for (int k = 0; k < 16; ++k) EXPECT_NEAR(rotation[k / 4][k % 4], again[k / 4][k % 4], 1e-12) << i;
  }
}

TEST(Placement, ACameraThatStandsUprightHasNoAngleAboutZWhereverItLooks) {
  for (const double y : {0.0, 30.0, 120.0, 180.0, -150.0, -91.0})
    for (const double x : {-60.0, 0.0, 12.0}) {
      const dvec3 angles = angles_of(rotation_xyz({x, y, 0.0}));
      EXPECT_NEAR(angles.x, x, 1e-12) << y;
      EXPECT_NEAR(std::remainder(angles.y - y, 360.0), 0.0, 1e-12) << x;
      EXPECT_NEAR(angles.z, 0.0, 1e-12) << x << " " << y;
    }
  EXPECT_NEAR(glm::length(angles_of(rotation_xyz({150, 60, 180})) - dvec3(-30, 120, 0)), 0.0, 1e-12);
}

TEST(Placement, AnglesTowardADirectionTurnZThere) {
  for (const dvec3 direction : {dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0, 0, -1), dvec3(0.48, 0.6, -0.64)})
    EXPECT_NEAR(glm::length(dvec3(rotation_xyz(angles_toward(direction)) * dvec4(0, 0, 1, 0)) - direction),
                0.0, 1e-15);
}

}  // namespace
}  // namespace plinian
