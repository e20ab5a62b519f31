// The artist's camera: what turns, what stays, what follows the mouse.
#include "host/window/navigation/free_camera.h"

#include <gtest/gtest.h>

#include "host/window/navigation/camera_history.h"

namespace plinian::window {
namespace {

Camera some_camera() {
  return look_at({3.0, 4.0, 10.0}, {0.5, 1.0, -0.5}, {0.0, 1.0, 0.0}, 40.0);
}

// Where a point is in the picture [pixels], y down.
dvec2 pixel_of(const Camera& camera, dvec3 point, ivec2 size) {
  const CameraRays rays = camera_rays(camera, size.x, size.y);
  const dvec3 d = point - dvec3(rays.origin);
  const double depth = glm::dot(d, dvec3(rays.forward));
  const dvec3 right(rays.right), up(rays.up);
  const double x = glm::dot(d, right) / glm::dot(right, right) / depth;
  const double y = glm::dot(d, up) / glm::dot(up, up) / depth;
  return {(x + 1.0) * 0.5 * size.x, (1.0 - y) * 0.5 * size.y};
}

double difference(const dmat4& a, const dmat4& b) {
  double largest = 0.0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
  return largest;
}

TEST(FreeCamera, StandsWhereTheCameraItIsMadeOfStands) {
  for (const double roll : {0.0, 25.0, -70.0}) {
    Camera camera = some_camera();
    camera.world_from_camera =
        glm::rotate(camera.world_from_camera, glm::radians(roll), dvec3(0.0, 0.0, 1.0));
    EXPECT_LT(difference(free_camera_at(camera, 7.0).camera().world_from_camera, camera.world_from_camera),
              1e-9);
  }
}

TEST(FreeCamera, StandsWhereACameraStandsThatLooksStraightDown) {
  Camera camera;
  camera.world_from_camera = glm::rotate(dmat4(1.0), glm::radians(-90.0), dvec3(1.0, 0.0, 0.0));
  camera.world_from_camera[3] = dvec4(1.0, 5.0, 2.0, 1.0);
  EXPECT_LT(difference(free_camera_at(camera, 5.0).camera().world_from_camera, camera.world_from_camera),
            1e-7);
}

TEST(FreeCamera, TumblingKeepsTheInterestInTheMiddleAndItsDistance) {
  const FreeCamera before = free_camera_at(some_camera(), 8.0);
  const FreeCamera after = tumble(before, {130.0, -45.0});
  const ivec2 size(640, 480);
  EXPECT_LT(glm::length(pixel_of(after.camera(), before.interest, size) - dvec2(320.0, 240.0)), 1e-3);
  EXPECT_NEAR(glm::length(dvec3(after.camera().world_from_camera[3]) - before.interest), 8.0, 1e-9);
  EXPECT_GT(glm::length(dvec3(after.camera().world_from_camera[3] - before.camera().world_from_camera[3])),
            1.0);
}

// Dragging right turns the scene to the right, as if it were held: the camera goes left.
TEST(FreeCamera, TumblingToTheRightTurnsTheSceneToTheRight) {
  FreeCamera camera;
  camera.distance = 10.0;
  const ivec2 size(400, 400);
  const dvec3 in_front(0.0, 0.0, 1.0);
  const dvec2 before = pixel_of(camera.camera(), in_front, size);
  EXPECT_GT(pixel_of(tumble(camera, {20.0, 0.0}).camera(), in_front, size).x, before.x);
  EXPECT_GT(pixel_of(tumble(camera, {0.0, 20.0}).camera(), in_front, size).y, before.y);
}

TEST(FreeCamera, TumblingNeverTurnsOverTheTop) {
  FreeCamera camera;
  for (int i = 0; i < 100; ++i) camera = tumble(camera, {0.0, 50.0});
  EXPECT_LT(camera.elevation, 90.0);
  EXPECT_GT(camera.camera().world_from_camera[1].y, 0.0) << "up is up";
}

TEST(FreeCamera, WhatIsTrackedFollowsTheMouse) {
  const FreeCamera before = free_camera_at(some_camera(), 9.0);
  const ivec2 size(800, 500);
  const dvec2 delta(63.0, -21.0);
  const dvec2 from = pixel_of(before.camera(), before.interest, size);
  const dvec2 to = pixel_of(track(before, delta, size).camera(), before.interest, size);
  EXPECT_LT(glm::length(to - from - delta), 1e-2);
}

TEST(FreeCamera, AHundredPointsOfDollyHalveTheDistance) {
  const FreeCamera before = free_camera_at(some_camera(), 6.0);
  EXPECT_NEAR(dolly(before, 100.0).distance, 3.0, 1e-9);
  EXPECT_NEAR(dolly(dolly(before, 37.0), -37.0).distance, 6.0, 1e-9);
  EXPECT_EQ(dolly(before, 100.0).interest, before.interest);
  EXPECT_GT(dolly(before, 1e9).distance, 0.0) << "never through the interest";
}

TEST(FreeCamera, FramingShowsEverythingFromTheSameSide) {
  SceneBounds bounds;
  bounds.minimum = dvec3(2.0, -1.0, 3.0);
  bounds.maximum = dvec3(4.0, 5.0, 6.0);
  for (int i = 0; i < 8; ++i)
    bounds.outline.push_back({i & 1 ? 2.0 : 4.0, i & 2 ? -1.0 : 5.0, i & 4 ? 3.0 : 6.0});
  const FreeCamera before = free_camera_at(some_camera(), 9.0);
  const ivec2 size(700, 400);
  const FreeCamera after = frame(before, bounds, size);
  EXPECT_NEAR(after.azimuth, before.azimuth, 1e-9);
  EXPECT_NEAR(after.elevation, before.elevation, 1e-6);
  double nearest = 1e9;
  for (const dvec3& point : bounds.outline) {
    const dvec2 p = pixel_of(after.camera(), point, size);
    nearest = std::min({nearest, p.x, p.y, size.x - p.x, size.y - p.y});
  }
  EXPECT_GT(nearest, 0.0) << "all of it is in the picture";
  EXPECT_LT(nearest, 60.0) << "and fills it";
}

TEST(FreeCamera, IsFramedForOneSizeUntilItIsMovedOrRolled) {
  SceneBounds bounds;
  bounds.minimum = dvec3(-2.0, 0.0, -1.0);
  bounds.maximum = dvec3(2.0, 5.0, 1.0);
  for (int i = 0; i < 8; ++i)
    bounds.outline.push_back(glm::mix(bounds.minimum, bounds.maximum, dvec3(i & 1, i >> 1 & 1, i >> 2)));
  const ivec2 size(512, 512);
  const Camera framed = frame_bounds(some_camera(), bounds, 30.0, -4.0, size.x, size.y);
  EXPECT_TRUE(is_framed(framed, bounds, size));
  EXPECT_FALSE(is_framed(framed, bounds, {640, 480}));
  Camera moved = framed;
  moved.world_from_camera[3].x += 0.1;
  EXPECT_FALSE(is_framed(moved, bounds, size));
  Camera rolled = framed;
  rolled.world_from_camera = glm::rotate(rolled.world_from_camera, glm::radians(5.0), dvec3(0.0, 0.0, 1.0));
  EXPECT_FALSE(is_framed(rolled, bounds, size));
}

TEST(CameraHistory, GoesBackAndForthAndForgetsWhatWasTakenBack) {
  CameraHistory history;
  Look scene, first, second;
  first.free = FreeCamera{.azimuth = 1.0};
  second.free = FreeCamera{.azimuth = 2.0};
  EXPECT_FALSE(history.back(scene));
  history.note(scene);
  history.note(first);
  const auto back = history.back(second);
  ASSERT_TRUE(back && back->free);
  EXPECT_EQ(back->free->azimuth, 1.0);
  const auto further = history.back(*back);
  ASSERT_TRUE(further);
  EXPECT_FALSE(further->free) << "the scene's own camera";
  EXPECT_EQ(history.forth(*further)->free->azimuth, 1.0);
  history.note(first);
  EXPECT_FALSE(history.forth(second));
}

}  // namespace
}  // namespace plinian::window
