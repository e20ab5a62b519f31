// Which pictures of frames that were played are kept, and for how long.
#include "host/window/view/played_frames.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plinian::window {
namespace {

// Of a frame in which a ball is that dense.
ViewPicture picture_of(float density, int side, int passes = 1, bool quick = false) {
  ViewPicture picture;
  Medium medium;
  medium.shape = MediumShape::sphere;
  medium.density_scale = density;
  picture.scene.media.push_back(medium);
  picture.scene.width = picture.scene.height = 64;
  picture.frame.width = picture.frame.height = side;
  picture.frame.beauty.assign(std::size_t(side) * std::size_t(side), vec3(density));
  picture.frame.transmittance = picture.frame.beauty;
  picture.frame.depth.assign(picture.frame.beauty.size(), 1.0f);
  picture.frame.lights.push_back({"key", picture.frame.beauty});
  picture.time = density;
  picture.passes = passes;
  picture.quick = quick;
  return picture;
}

std::vector<double> sorted(std::vector<double> frames) {
  std::sort(frames.begin(), frames.end());
  return frames;
}

TEST(PlayedFrames, APictureIsFoundByWhatItShows) {
  PlayedFrames played;
  played.keep(picture_of(1.0f, 64));
  played.keep(picture_of(2.0f, 64));
  const ViewPicturePtr found = played.find(picture_of(2.0f, 64).scene);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_played);
  EXPECT_EQ(found->frame.beauty, picture_of(2.0f, 64).frame.beauty);
  EXPECT_TRUE(found->frame.lights.empty()) << "its layers would take most of the memory";
  EXPECT_EQ(played.find(picture_of(3.0f, 64).scene), nullptr);
  EXPECT_EQ(sorted(played.frames()), (std::vector<double>{1.0, 2.0}));
}

TEST(PlayedFrames, TheBetterPictureStays) {
  PlayedFrames played;
  played.keep(picture_of(1.0f, 16, 1, true));
  EXPECT_TRUE(played.frames().empty()) << "a quick picture is not what is promised";
  played.keep(picture_of(1.0f, 64, 1));
  played.keep(picture_of(1.0f, 64, 4));
  played.keep(picture_of(1.0f, 64, 2));
  played.keep(picture_of(1.0f, 16, 1, true));
  EXPECT_EQ(played.find(picture_of(1.0f, 64).scene)->passes, 4);
  EXPECT_EQ(played.frames(), std::vector<double>{1.0});
  const std::size_t one = played.bytes();
  played.keep(picture_of(2.0f, 64, 4));
  EXPECT_EQ(played.bytes(), 2 * one);
}

TEST(PlayedFrames, WhatWasNotAskedForTheLongestLeavesFirst) {
  constexpr std::size_t bytes = 64 * 64 * (2 * sizeof(vec3) + sizeof(float));
  PlayedFrames played(2 * bytes);
  played.keep(picture_of(1.0f, 64));
  played.keep(picture_of(2.0f, 64));
  played.find(picture_of(1.0f, 64).scene);
  played.keep(picture_of(3.0f, 64));
  EXPECT_EQ(sorted(played.frames()), (std::vector<double>{1.0, 3.0}));
  EXPECT_LE(played.bytes(), 2 * bytes);
}

TEST(PlayedFrames, AnotherTakeBeginsWithNone) {
  PlayedFrames played;
  Take take;
  take.generation = 5;
  take.size = {64, 64};
  EXPECT_TRUE(played.begin(take));
  played.keep(picture_of(1.0f, 64));
  EXPECT_FALSE(played.begin(take));
  EXPECT_FALSE(played.frames().empty());
  take.free = look_at({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 40.0);
  EXPECT_TRUE(played.begin(take)) << "through another camera";
  EXPECT_TRUE(played.frames().empty());
  EXPECT_EQ(played.bytes(), 0u);
  EXPECT_FALSE(played.begin(take));
}

}  // namespace
}  // namespace plinian::window
