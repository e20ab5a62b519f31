// What is drawn over the picture, without a window: where points are seen, grid, boxes, and clicks.
#include "host/window/overlay/overlay.h"

#include <gtest/gtest.h>

#include "host/window/overlay/ground_grid.h"
#include "host/window/overlay/overlay_choice.h"
#include "host/window/overlay/pick.h"
#include "host/window/overlay/projection.h"
#include "host/window/view/media_extent.h"

namespace plinian::window {
namespace {

// 90 degrees high, looking along -z from (0, 0, 10): a picture of 200 x 100 points shows +-20 by +-10 there.
Projection ten_away() {
  return {look_at({0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 90.0), 400, 200, vec2(50, 20), vec2(200, 100)};
}

TEST(OverlayProjection, PutsPointsWhereTheRaysOfTheirPixelsRun) {
  const Projection projection = ten_away();
  const auto middle = projection.point({0, 0, 0}), corner = projection.point({20, 10, 0});
  ASSERT_TRUE(middle && corner);
  EXPECT_NEAR(middle->at.x, 150.0f, 1e-3f);
  EXPECT_NEAR(middle->at.y, 70.0f, 1e-3f);
  EXPECT_NEAR(middle->depth, 10.0, 1e-5);
  EXPECT_NEAR(corner->at.x, 250.0f, 1e-3f);
  EXPECT_NEAR(corner->at.y, 20.0f, 1e-3f);
  EXPECT_FALSE(projection.point({0, 0, 11})) << "behind the eye";
  EXPECT_NEAR(projection.length_of_point(10.0), 0.2, 1e-6);
  const dvec3 ray = projection.direction({250, 20});
  EXPECT_NEAR(ray.x / -ray.z, 2.0, 1e-5);
  EXPECT_NEAR(ray.y / -ray.z, 1.0, 1e-5);
}

TEST(OverlayProjection, CutsLinesAtThePictureAndBeforeTheEye) {
  const Projection projection = ten_away();
  const auto across = projection.line({-100, 0, 0}, {100, 0, 0});
  ASSERT_TRUE(across);
  EXPECT_NEAR(across->first.x, 50.0f, 1e-3f);
  EXPECT_NEAR(across->second.x, 250.0f, 1e-3f);
  // From the middle of the picture past the eye: it leaves by the upper edge, never turned round to below.
  const auto past = projection.line({0, 0, 0}, {0, 1, 20});
  ASSERT_TRUE(past);
  EXPECT_NEAR(past->first.y, 70.0f, 1e-3f);
  EXPECT_NEAR(past->second.y, 20.0f, 1e-2f);
  EXPECT_FALSE(projection.line({0, 0, 11}, {5, 5, 30}));
  EXPECT_FALSE(projection.line({30, 0, 0}, {40, 5, 0})) << "beside the picture";
}

TEST(GroundGrid, HasRoundSpacingAndFadesAwayFromWhatItIsUnder) {
  EXPECT_DOUBLE_EQ(round_length(7.3), 5.0);
  EXPECT_DOUBLE_EQ(round_length(4.9), 2.0);
  EXPECT_DOUBLE_EQ(round_length(1000.0), 1000.0);
  EXPECT_DOUBLE_EQ(round_length(0.03), 0.02);
  bool through_origin = false;
  for (const GridLine& line : ground_grid({3.2, 7.0, -1.0}, 0.5)) {
    EXPECT_EQ(line.from.y, 0.0);
    const bool along_z = line.from.x == line.to.x;
    const double at = along_z ? line.from.x : line.from.z;
    EXPECT_NEAR(at / 0.5, std::round(at / 0.5), 1e-9) << "lines stand at multiples of the spacing";
    EXPECT_EQ(line.is_axis, at == 0.0);
    through_origin |= line.is_axis;
    const dvec3 middle = (line.from + line.to) * 0.5;
    const double far = glm::length(dvec2(middle.x - 3.0, middle.z + 1.0)) / 10.0;
    EXPECT_NEAR(line.strength, (1.0 - far) * (1.0 - far), 1e-5);
  }
  EXPECT_TRUE(through_origin);
}

TEST(MediaExtent, IsToldAgainOnlyWhereAMediumIsAnotherOrElsewhere) {
  std::vector<Medium> media(2);
  media[0].shape = MediumShape::box;
  const MediaExtent::Ptr extent = MediaExtent::of(media);
  ASSERT_NE(extent->medium(0), nullptr);
  EXPECT_EQ(extent->medium(1), nullptr) << "of no volume";
  EXPECT_EQ(extent->all().maximum, dvec3(1.0));
  media[0].density_scale = 3.0f;
  EXPECT_EQ(MediaExtent::of(media, extent), extent);
  media[0].world_from_medium = glm::translate(dmat4(1.0), dvec3(4.0, 0.0, 0.0));
  const MediaExtent::Ptr moved = MediaExtent::of(media, extent);
  EXPECT_EQ(moved->medium(0)->minimum.x, 3.0);
  EXPECT_EQ(extent->medium(0)->minimum.x, -1.0) << "a picture keeps its own";
}

TEST(Pick, MeetsTheMediumInFront) {
  EXPECT_NEAR(*box_ahead({0, 0, 5}, {0, 0, -2}, dvec3(-1), dvec3(1)), 2.0, 1e-12);
  EXPECT_EQ(*box_ahead({0, 0, 0}, {0, 0, -2}, dvec3(-1), dvec3(1)), 0.0) << "from inside";
  EXPECT_FALSE(box_ahead({0, 0, 5}, {0, 0, 2}, dvec3(-1), dvec3(1))) << "behind";
  EXPECT_FALSE(box_ahead({2, 0, 5}, {0, 0, -2}, dvec3(-1), dvec3(1))) << "beside";
  SceneSnapshot scene;
  for (const double z : {-6.0, 2.0, -3.0}) {
    Medium ball;
    ball.shape = MediumShape::sphere;
    ball.world_from_medium = glm::translate(dmat4(1.0), dvec3(0, 0, z));
    scene.media.push_back(ball);
  }
  EXPECT_EQ(medium_ahead(scene, {0, 0, 10}, {0, 0, -1}), std::size_t(1));
  EXPECT_EQ(medium_ahead(scene, {0, 0, -20}, {0, 0, 1}), std::size_t(0));
  EXPECT_EQ(medium_ahead(scene, {0, 0, 10}, {0, 1, 0}), std::nullopt);
}

// One ball in front of another whose box is wider, seen by pictures of one pixel.
TEST(Pick, TakesWhatIsSeenUnderTheMouseAndNothingWhereNothingIs) {
  SceneSnapshot scene;
  for (const double z : {-6.0, 2.0}) {
    Medium ball;
    ball.shape = MediumShape::sphere;
    ball.world_from_medium = glm::translate(dmat4(1.0), dvec3(0, 0, z));
    scene.media.push_back(ball);
  }
  const auto seen = [&](float transmittance, float depth) {
    Frame frame;
    frame.width = frame.height = 1;
    frame.transmittance = {vec3(transmittance)};
    frame.depth = {depth};
    return medium_seen(scene, frame, {0.5f, 0.5f}, {0, 0, 10}, {0, 0, -1});
  };
  EXPECT_EQ(seen(0.0f, 7.5f), std::size_t(1)) << "on the one in front";
  EXPECT_EQ(seen(0.0f, 15.5f), std::size_t(0)) << "through it, on the one behind";
  EXPECT_EQ(seen(0.7f, INFINITY), std::size_t(1)) << "a veil has no depth: the one in front";
  EXPECT_EQ(seen(1.0f, INFINITY), std::nullopt) << "in both boxes, but nothing is there";
}

TEST(Pick, AHandNeedNotBeExact) {
  SceneSnapshot scene;
  scene.media.emplace_back().shape = MediumShape::sphere;
  Frame frame;
  frame.width = frame.height = 200;
  frame.transmittance.assign(40000, vec3(1.0f));
  frame.depth.assign(40000, INFINITY);
  frame.transmittance[100 * 200 + 102] = vec3(0.0f);
  frame.depth[100 * 200 + 102] = 9.5f;
  const auto seen = [&](float x) {
    return medium_seen(scene, frame, {x / 200.0f, 100.5f / 200.0f}, {0, 0, 10}, {0, 0, -1});
  };
  EXPECT_TRUE(seen(100.5f)) << "two pixels beside a thread";
  EXPECT_FALSE(seen(90.5f));
}

TEST(SelectCommand, FollowsTheKeysThatAreHeld) {
  EXPECT_EQ(select_command("key", false, false, true, true), "select key");
  EXPECT_EQ(select_command("key", true, false, false, true), "select key -add");
  EXPECT_EQ(select_command("key", false, true, false, true), "select key -add");
  EXPECT_EQ(select_command("key", false, true, true, true), "select key -remove");
  EXPECT_EQ(select_command("", false, false, false, true), "select -clear");
  EXPECT_EQ(select_command("", false, false, false, false), "") << "nothing to clear";
  EXPECT_EQ(select_command("", true, false, false, true), "") << "a click that misses keeps what was added";
}

TEST(OverlayChoice, WhatIsHiddenIsRememberedAndUnknownWordsHideNothing) {
  OverlayChoice choice;
  EXPECT_EQ(text_of(choice), "");
  choice.grid = choice.drawings = choice.handles = false;
  const OverlayChoice again = read_overlay_choice(text_of(choice) + "nonsense\n");
  EXPECT_FALSE(again.grid);
  EXPECT_FALSE(again.drawings);
  EXPECT_FALSE(again.handles);
  EXPECT_TRUE(again.axes && again.scale_bar && again.bounds && again.icons && again.gate);
}

}  // namespace
}  // namespace plinian::window
