// What is read out under the pointer, of the picture and of the one beside it.
#include "host/window/compare/pixel_readout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plinian::window {
namespace {

// A ramp along x on which a medium covers all but the last column.
std::shared_ptr<ViewPicture> ramp(float gain, ivec2 size = {8, 4}) {
  auto picture = std::make_shared<ViewPicture>();
  Frame& frame = picture->frame;
  frame.width = picture->scene.width = size.x;
  frame.height = picture->scene.height = size.y;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const bool empty = x == size.x - 1;
      frame.beauty.push_back(empty ? vec3(0.0f) : gain * vec3(0.1f * float(x + 1), 0.2f, 0.01f * float(y)));
      frame.transmittance.push_back(vec3(empty ? 1.0f : 0.25f));
      frame.depth.push_back(empty ? INFINITY : 6.5f);
    }
  const std::size_t pixels = frame.beauty.size();
  frame.lights = {{"key", std::vector<vec3>(pixels, vec3(0.5f * gain))}};
  frame.ambient = frame.emission = frame.background = std::vector<vec3>(pixels, vec3(0.0f));
  return picture;
}

// In the middle of a pixel.
vec2 at(int x, int y, ivec2 size = {8, 4}) {
  return (vec2(x, y) + 0.5f) / vec2(size);
}

void expect_near(vec3 a, vec3 b) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-5f) << c;
}

FilePicturePtr file_of(const ViewPicture& picture, bool has_alpha) {
  auto file = std::make_shared<FilePicture>();
  file->picture.frame = picture.frame;
  file->picture.has_alpha = has_alpha;
  return file;
}

TEST(PixelReadout, ItIsOfThePixelUnderThePointerAsItIsSeen) {
  Development how;
  const DevelopedPtr shown = develop(ramp(1.0f), how);
  auto readout = read_pixel(*shown, how, at(2, 3), std::nullopt, "");
  ASSERT_TRUE(readout);
  EXPECT_EQ(readout->pixel, ivec2(2, 3));
  expect_near(readout->picture.radiance, {0.3f, 0.2f, 0.03f});
  EXPECT_FLOAT_EQ(*readout->picture.alpha, 0.75f);
  EXPECT_EQ(readout->picture.depth, 6.5f);
  EXPECT_FALSE(readout->other);
  EXPECT_EQ(readout_lines(*readout),
            std::vector<std::string>{"   2    3   0.3000 0.2000 0.0300   a 0.750   z 6.5 m"});
  how.solo = {"key"};
  expect_near(read_pixel(*shown, how, at(2, 3), std::nullopt, "")->picture.radiance, vec3(0.5f));
  EXPECT_FALSE(read_pixel(*shown, how, {1.0f, 0.5f}, std::nullopt, "")) << "beside it";
  EXPECT_FALSE(read_pixel(*shown, how, {-0.01f, 0.5f}, std::nullopt, ""));
}

// Else one would tune a density by radiance.
TEST(PixelReadout, ItIsOfTheLayerThatIsSeen) {
  Development how;
  const auto picture = ramp(1.0f);
  const auto lines = [&] {
    const std::optional<vec2> other_at = how.against ? std::optional(at(2, 3)) : std::nullopt;
    return readout_lines(*read_pixel(*develop(picture, how), how, at(2, 3), other_at, "snapshot 1"));
  };
  using Lines = std::vector<std::string>;
  how.layer = "alpha";
  EXPECT_EQ(lines(), Lines{"   2    3   alpha 0.7500   z 6.5 m"});
  how.layer = "depth";
  EXPECT_EQ(lines(), Lines{"   2    3   depth 6.5 m"});
  how.layer = "ambient";
  EXPECT_EQ(lines(), Lines{"   2    3   ambient 0.0000 0.0000 0.0000   a 0.750   z 6.5 m"});
  const auto thinner = ramp(1.0f);
  thinner->frame.transmittance.assign(thinner->frame.beauty.size(), vec3(0.5f));
  how.against = thinner;
  how.layer = "alpha";
  EXPECT_EQ(lines(), (Lines{"   2    3  alpha  0.7500   z 6.5 m", "snapshot 1 alpha  0.5000   z 6.5 m",
                            "difference alpha +0.2500"}));
  how.solo = {"key"};
  EXPECT_EQ(lines()[0], "   2    3   0.5000  0.5000  0.5000  a  0.750   z 6.5 m")
      << "lights that are shown alone are what is seen";
}

// It has fewer pixels; the place is told in those of the one at rest.
TEST(PixelReadout, AQuickPictureIsReadWhereThePointerIs) {
  const auto quick = ramp(1.0f, {4, 2});
  quick->quick = true;
  quick->scene.width = 8;
  quick->scene.height = 4;
  Development how;
  const auto readout = read_pixel(*develop(quick, how), how, at(4, 3), std::nullopt, "");
  EXPECT_EQ(readout->pixel, ivec2(4, 3));
  expect_near(readout->picture.radiance, {0.3f, 0.2f, 0.01f});
}

TEST(PixelReadout, TheOtherIsReadAtItsPlaceAndTheyAreSubtracted) {
  Development how;
  how.against = ramp(0.5f);
  const DevelopedPtr shown = develop(ramp(1.0f), how);
  const auto readout = read_pixel(*shown, how, at(2, 3), at(2, 3), "snapshot 1");
  ASSERT_TRUE(readout->other);
  expect_near(readout->other->radiance, {0.15f, 0.1f, 0.015f});
  EXPECT_EQ(readout->matched, "");
  const std::vector<std::string> lines = {"   2    3   0.3000  0.2000  0.0300  a  0.750   z 6.5 m",
                                          "snapshot 1  0.1500  0.1000  0.0150  a  0.750   z 6.5 m",
                                          "difference +0.1500 +0.1000 +0.0150  a +0.000"};
  EXPECT_EQ(readout_lines(*readout), lines);
  const std::vector<std::string> narrow = {lines[0].substr(0, 44), lines[1].substr(0, 44), lines[2]};
  EXPECT_EQ(readout_lines(*readout, 46), narrow);
  // In its own shape it may lie elsewhere, or not be there.
  expect_near(read_pixel(*shown, how, at(2, 3), at(4, 0), "")->other->radiance, {0.25f, 0.1f, 0.0f});
  EXPECT_FALSE(read_pixel(*shown, how, at(2, 3), vec2(1.2f, 0.5f), "")->other);
  EXPECT_FALSE(read_pixel(*shown, how, at(2, 3), std::nullopt, "")->other);
}

// In the units that the metrics are of.
TEST(PixelReadout, AFileIsReadAsItWasMatched) {
  Development how;
  how.against = ramp(0.25f);
  how.against_file = file_of(*how.against, false);
  how.matching.exposure = true;
  const DevelopedPtr shown = develop(ramp(1.0f), how);
  auto readout = read_pixel(*shown, how, at(5, 1), at(5, 1), "ref.exr");
  ASSERT_TRUE(readout->other);
  expect_near(readout->other->radiance, readout->picture.radiance);
  EXPECT_EQ(readout->matched, "matched by +2.00 EV");
  EXPECT_FALSE(readout->other->alpha) << "it has none";
  const std::vector<std::string> lines = readout_lines(*readout);
  EXPECT_EQ(lines[1].substr(lines[1].size() - 22), "   matched by +2.00 EV");
  EXPECT_EQ(lines[2], "difference +0.0000 +0.0000 +0.0000");
  how.matching = {};
  readout = read_pixel(*develop(ramp(1.0f), how), how, at(5, 1), at(5, 1), "ref.exr");
  expect_near(readout->other->radiance, 0.25f * readout->picture.radiance);
  EXPECT_EQ(readout->matched, "");
}

TEST(PixelReadout, WhatCannotBeMatchedIsSaidToBeSo) {
  Development how;
  how.against = ramp(0.25f, {16, 8});
  how.against_file = file_of(*how.against, true);
  how.matching.exposure = true;
  const auto picture = ramp(1.0f);
  const auto readout = read_pixel(*develop(picture, how), how, at(2, 1), at(4, 3, {16, 8}), "ref.exr");
  ASSERT_TRUE(readout->other);
  expect_near(readout->other->radiance, 0.25f * vec3(0.5f, 0.2f, 0.03f));
  EXPECT_EQ(readout->matched, "not matched");
  how.layer = "emission";
  EXPECT_FALSE(read_pixel(*develop(picture, how), how, at(2, 1), at(4, 3, {16, 8}), "ref.exr")->other)
      << "it does not have that layer";
}

// The hand that turns a light sees the same radiance of the other as at rest.
TEST(PixelReadout, AQuickPictureIsHeldAgainstWhatWasMatched) {
  Development how;
  how.against = ramp(0.25f);
  how.against_file = file_of(*how.against, false);
  how.matching.exposure = true;
  const DevelopedPtr whole = develop(ramp(1.0f), how);
  const auto quick = ramp(1.0f, {4, 2});
  quick->quick = true;
  quick->scene.width = 8;
  quick->scene.height = 4;
  const Measured last{how, whole->other, whole->figures->matched};
  const DevelopedPtr shown = develop(quick, how, &last);
  const auto readout = read_pixel(*shown, how, at(5, 1), at(5, 1), "ref.exr");
  expect_near(readout->other->radiance, {0.6f, 0.2f, 0.01f});
  EXPECT_EQ(readout->matched, "matched by +2.00 EV");
}

}  // namespace
}  // namespace plinian::window
