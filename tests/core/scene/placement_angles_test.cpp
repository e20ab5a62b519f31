#include "core/scene/placement_angles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plinian {
namespace {

void expect_near(const dvec3& a, const dvec3& b, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

TEST(PlacementAngles, MakeTheRotationInEveryOrder) {
  for (int order = 0; order < 6; ++order)
    for (const dvec3& start : {dvec3(0), dvec3(30, -50, 110), dvec3(-170, 89, 20), dvec3(10, 90, -40),
                               dvec3(90, 0, 0), dvec3(5, -20, -90)}) {
      const dmat3 matrix(matrix_of({.rotate = start, .order = RotateOrder(order)}));
      const dvec3 angles = angles_of(matrix, RotateOrder(order), start);
      expect_near(angles, start, 1e-5);
      const dvec3 axis = glm::normalize(dvec3(0.3, -0.5, 0.8));
      const dmat3 after(matrix_of(
          {.rotate = turned_angles(start, RotateOrder(order), axis, 73.0), .order = RotateOrder(order)}));
      // Rodrigues' formula on each column.
      for (int i = 0; i < 3; ++i) {
        const double s = std::sin(glm::radians(73.0)), c = std::cos(glm::radians(73.0));
        const dvec3 wanted =
            matrix[i] * c + glm::cross(axis, matrix[i]) * s + axis * (glm::dot(axis, matrix[i]) * (1.0 - c));
        expect_near(after[i], wanted, 1e-6);
      }
    }
}

TEST(PlacementAngles, SeveralTurnsCount) {
  expect_near(turned_angles({5, 0, 0}, RotateOrder::xyz, {1, 0, 0}, 765.0), {770, 0, 0}, 1e-6);
  // About its first axis, which is its own, one angle changes alone.
  const dvec3 start(10, 40, 70);
  const dvec3 own(matrix_of({.rotate = start})[0]);
  expect_near(turned_angles(start, RotateOrder::xyz, own, -33.0), {-23, 40, 70}, 1e-6);
  expect_near(turned_angles(start, RotateOrder::xyz, {0, 0, 1}, 25.0), {10, 40, 95}, 1e-6);
}

TEST(PlacementAngles, OfAStretchedSpaceTheTurnIsFound) {
  const dmat3 rotation(rotation_xyz({20, 30, 40}));
  dmat3 stretch(1.0);
  stretch[0][0] = 4.0, stretch[1][1] = 0.5;
  const dmat3 found = turning_part(rotation * stretch);
  for (int i = 0; i < 3; ++i) expect_near(found[i], rotation[i], 1e-12);
  stretch[2][2] = -3.0;
  EXPECT_NEAR(glm::determinant(turning_part(rotation * stretch)), -1.0, 1e-12);
}

TEST(PlacementOfMatrix, IsFoundInEveryOrderAboutItsPivot) {
  for (int order = 0; order < 6; ++order)
    for (const dvec3& scale : {dvec3(1), dvec3(2, 0.5, 3), dvec3(-1, 2, 1), dvec3(-2, -0.1, -3)}) {
      const Placement placed{.translate = {1, -20, 0.3},
                             .rotate = {30, -50, 110},
                             .order = RotateOrder(order),
                             .scale = scale,
                             .pivot = {0.5, 4, -2}};
      Placement like = placed;
      like.translate = dvec3(7);
      like.rotate += dvec3(5);
      const auto found = placement_of(matrix_of(placed), like);
      ASSERT_TRUE(found);
      EXPECT_FALSE(found->sheared);
      expect_near(found->placement.translate, placed.translate, 1e-9);
      expect_near(found->placement.rotate, placed.rotate, 1e-9);
      expect_near(found->placement.scale, placed.scale, 1e-9);
      EXPECT_EQ(found->placement.translate.z, 0.3) << "reads as it was written";
    }
}

TEST(PlacementOfMatrix, OfAShearedMatrixIsTheNearestOneAndSaysSo) {
  // A quarter between the axes of what stretches by 4.
  const dmat4 parent = matrix_of({.scale = {4, 1, 1}}), own = matrix_of({.rotate = {0, 0, 45}});
  const auto found = placement_of(parent * own, {});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->sheared);
  EXPECT_FALSE(placement_of(parent, {})->sheared);
  // The nearest rotation leaves what is symmetric: both axes grow by the same.
  EXPECT_NEAR(found->placement.scale.x, found->placement.scale.y, 1e-9);
  EXPECT_NEAR(found->placement.scale.z, 1.0, 1e-9);
}

TEST(PlacementOfMatrix, ThereIsNoneOfWhatIsFlat) {
  EXPECT_FALSE(placement_of(matrix_of({.scale = {1, 0, 1}}), {}));
}

}  // namespace
}  // namespace plinian
