#include "core/image/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/core/image/temporary_folder.h"

namespace plinian {
namespace {

Frame two_pixels() {
  Frame frame;
  frame.width = 2;
  frame.height = 1;
  frame.beauty = {vec3(1, 2, 3), vec3(4, 5, 6)};
  frame.transmittance = {vec3(0.5f, 0.25f, 0.75f), vec3(1.0f)};
  frame.depth = {7.5f, std::numeric_limits<float>::infinity()};
  frame.ambient = {vec3(0.1f), vec3(0.2f)};
  frame.emission = {vec3(0.3f), vec3(0.4f)};
  frame.background = {vec3(0.5f), vec3(0.6f)};
  frame.lights = {{"key", {vec3(8), vec3(9)}}, {"key", {vec3(10), vec3(11)}}};
  return frame;
}

TEST(Image, FrameBecomesNamedChannels) {
  const Image image = frame_to_image(two_pixels());
  std::vector<std::string> names;
  for (const Channel& channel : image.channels) names.push_back(channel.name);
  const std::vector<std::string> expected{"R",
                                          "G",
                                          "B",
                                          "A",
                                          "Z",
                                          "transmittance.R",
                                          "transmittance.G",
                                          "transmittance.B",
                                          "ambient.R",
                                          "ambient.G",
                                          "ambient.B",
                                          "emission.R",
                                          "emission.G",
                                          "emission.B",
                                          "background.R",
                                          "background.G",
                                          "background.B",
                                          "key.R",
                                          "key.G",
                                          "key.B",
                                          "key_2.R",
                                          "key_2.G",
                                          "key_2.B"};
  EXPECT_EQ(names, expected);
  EXPECT_EQ(image.find("G")->values, (std::vector<float>{2, 5}));
  EXPECT_EQ(image.find("A")->values, (std::vector<float>{0.5f, 0.0f}));  // 1 - (0.5 + 0.25 + 0.75) / 3
  EXPECT_EQ(image.find("Z")->values[0], 7.5f);
  EXPECT_TRUE(std::isinf(image.find("Z")->values[1]));
  EXPECT_EQ(image.find("key_2.B")->values, (std::vector<float>{10, 11}));
}

TEST(Image, LightNamesAreMadeSafeAndNeverHideALayer) {
  Frame frame = two_pixels();
  frame.lights[0].name = "ambient";
  frame.lights[1].name = "sun.dusk über";
  frame.lights.push_back({"", {vec3(0), vec3(0)}});
  const Image image = frame_to_image(frame);
  EXPECT_TRUE(image.find("ambient_2.R"));
  EXPECT_TRUE(image.find("sun_dusk___ber.R"));
  EXPECT_TRUE(image.find("light.R"));
}

TEST(Image, AFrameWithAMissingPlaneIsRefused) {
  Frame frame = two_pixels();
  frame.emission.pop_back();
  EXPECT_NE(message_of<ImageError>([&] { frame_to_image(frame); }).find("emission has 1 pixels, expected 2"),
            std::string::npos);
}

TEST(Image, ColourIsFoundUnderTheNamesThatRenderersUse) {
  Image image;
  image.width = image.height = 1;
  image.add("Depth.Z", 9.0f);
  EXPECT_EQ(colour_of(image)[0], vec3(9.0f)) << "the only channel";
  for (const char* c : {"ViewLayer.Normal.R", "ViewLayer.Normal.G", "ViewLayer.Normal.B"}) image.add(c, 1.0f);
  for (const char* c : {"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B"})
    image.add(c, 2.0f);
  EXPECT_EQ(colour_of(image)[0], vec3(2.0f));
  image.add("R", 3.0f), image.add("G", 4.0f), image.add("B", 5.0f);
  EXPECT_EQ(colour_of(image)[0], vec3(3, 4, 5));
}

TEST(Image, NoColourIsAnErrorThatListsTheChannels) {
  Image image;
  image.width = image.height = 1;
  image.add("Z");
  image.add("N");
  EXPECT_NE(message_of<ImageError>([&] { colour_of(image); }).find("(Z, N)"), std::string::npos);
}

TEST(Image, BoxDownsampleAveragesBlocksAndTheRest) {
  Image image = make_image(3, 2);
  image.find("R")->values = {1, 2, 10, 3, 6, 20};
  const Image small = box_downsample(image, 2);
  EXPECT_EQ(small.width, 2);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(small.find("R")->values, (std::vector<float>{3.0f, 15.0f}));
}

TEST(Image, CameraMatricesPutAPixelsRayWhereThePixelIs) {
  Camera camera = look_at(dvec3(3, 2, 5), dvec3(0, 1, 0), dvec3(0, 1, 0), 40.0);
  camera.film_offset = vec2(3.0f, -2.0f);
  Image image = make_image(200, 100);
  add_camera_metadata(image, camera);
  const mat4 ndc_from_world = std::get<mat4>(image.metadata.at(attribute::world_to_ndc));
  const CameraRays rays = camera_rays(camera, 200, 100);
  const float x = 0.4f, y = -0.7f;
  for (const float distance : {1.0f, 25.0f}) {
    const vec4 clip =
        ndc_from_world * vec4(rays.origin + distance * (rays.forward + x * rays.right + y * rays.up), 1.0f);
    EXPECT_NEAR(clip.x / clip.w, x, 1e-4f);
    EXPECT_NEAR(clip.y / clip.w, y, 1e-4f);
    EXPECT_NEAR(clip.z / clip.w, 1.0f - 1.0f / distance, 1e-4f);
  }
  const mat4 camera_from_world = std::get<mat4>(image.metadata.at(attribute::world_to_camera));
  const vec4 target = camera_from_world * vec4(0, 1, 0, 1);
  EXPECT_NEAR(target.z, -std::sqrt(35.0f), 1e-4f) << "the camera looks along -z";
  EXPECT_NEAR(target.x, 0.0f, 1e-4f);
}

}  // namespace
}  // namespace plinian
