// The camera of a picture as matrices, and its depth, without a window.
#include <gtest/gtest.h>

#include "core/scene/framing.h"
#include "host/window/drawing/canvas.h"
#include "host/window/drawing/view_matrices.h"
#include "host/window/overlay/projection.h"

namespace plinian::window {
namespace {

// Off the axis, with a shifted film, and not as wide as its film.
SceneSnapshot odd_scene() {
  SceneSnapshot scene;
  scene.camera = look_at({3, 2, 5}, {0.5, 0, 0}, {0.1, 1, 0}, 50.0);
  scene.camera.film_offset = vec2(4.0f, -3.0f);
  scene.camera.fit = FilmFit::overscan;
  scene.width = 60;
  scene.height = 50;
  Medium ball;
  ball.shape = MediumShape::sphere;
  scene.media.push_back(ball);
  return scene;
}

vec3 window_place(const ViewMatrices& matrices, const dvec3& world, ivec2 size) {
  const dvec4 clip = matrices.clip_from_view * matrices.view_from_world * dvec4(world, 1.0);
  const dvec3 seen = dvec3(clip) / clip.w * 0.5 + 0.5;
  return vec3(seen * dvec3(size.x, size.y, 1.0));
}

TEST(ViewMatrices, PutPointsWhereThePictureHasThem) {
  const SceneSnapshot scene = odd_scene();
  const ViewMatrices matrices = view_matrices(scene, scene_bounds(scene.media));
  const Projection projection(scene.camera, scene.width, scene.height, vec2(0), vec2(60, 50));
  for (const dvec3& world : {dvec3(0), dvec3(1, 0.5, -2), dvec3(-0.7, 0.2, 1), dvec3(2.5, 1.5, 4)}) {
    const auto expected = projection.point(world);
    ASSERT_TRUE(expected);
    const vec3 found = window_place(matrices, world, {60, 50});
    EXPECT_NEAR(found.x, expected->at.x, 1e-3f);
    EXPECT_NEAR(50.0f - found.y, expected->at.y, 1e-3f);
    EXPECT_GT(found.z, 0.0f);
    EXPECT_LT(found.z, 1.0f);
  }
}

// What lies a little in front of a medium is seen, what lies a little behind it is not, in every pixel.
TEST(ViewMatrices, TheDepthOfThePictureIsThatOfWhatStandsThere) {
  const SceneSnapshot scene = odd_scene();
  const ViewMatrices matrices = view_matrices(scene, scene_bounds(scene.media));
  Frame frame;
  frame.width = 6;  // it was rendered at a tenth of the sides
  frame.height = 5;
  for (int i = 0; i < 30; ++i) frame.depth.push_back(1.0f + 0.37f * float(i));
  frame.depth[7] = INFINITY;
  const ivec2 size(scene.width, scene.height);
  const std::vector<float> depths = depth_buffer_of(frame, scene, matrices, size);
  ASSERT_EQ(depths.size(), 3000u);
  const Projection projection(scene.camera, scene.width, scene.height, vec2(0), vec2(size));
  for (int y = 0; y < size.y; y += 3)
    for (int x = 0; x < size.x; x += 3) {
      const float depth = depths[std::size_t((size.y - 1 - y) * size.x + x)];
      const double distance = frame.depth[std::size_t(y / 10 * 6 + x / 10)];
      if (!std::isfinite(distance)) {
        EXPECT_EQ(depth, 1.0f);
        continue;
      }
      const dvec3 way = glm::normalize(projection.direction(vec2(x + 0.5f, y + 0.5f)));
      EXPECT_LT(window_place(matrices, projection.eye() + way * (distance * 0.9995), size).z, depth)
          << x << ' ' << y;
      EXPECT_GT(window_place(matrices, projection.eye() + way * (distance * 1.0005), size).z, depth)
          << x << ' ' << y;
    }
}

TEST(Canvas, BeginsWithThePictureTurnedAndAsLargeAsItWillBe) {
  Developed developed;
  developed.width = 3;
  developed.height = 2;
  for (int i = 0; i < 18; ++i) developed.bytes.push_back(std::uint8_t(10 * i));
  const std::vector<std::uint8_t> same = colour_buffer_of(developed, {3, 2});
  ASSERT_EQ(same.size(), 24u);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) {
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(same[std::size_t(4 * ((1 - y) * 3 + x) + c)], 10 * (3 * (3 * y + x) + c));
      EXPECT_EQ(same[std::size_t(4 * (3 * y + x) + 3)], 255);
    }
  // Along a row red is 0, 30, 60 at 1/6, 3/6, 5/6 of the width, and 90 more in the lower one.
  const std::vector<std::uint8_t> large = colour_buffer_of(developed, {12, 8});
  ASSERT_EQ(large.size(), 4u * 12u * 8u);
  const auto red = [&](int x, int y) { return int(large[std::size_t(4 * ((7 - y) * 12 + x))]); };
  EXPECT_EQ(red(0, 0), 0) << "no further than the outermost pixels";
  EXPECT_EQ(red(11, 7), 150);
  EXPECT_NEAR(red(6, 0), (6.5 / 12.0 * 3.0 - 0.5) * 30.0, 0.6);
  EXPECT_NEAR(red(6, 4), (6.5 / 12.0 * 3.0 - 0.5) * 30.0 + (4.5 / 8.0 * 2.0 - 0.5) * 90.0, 0.6);
}

}  // namespace
}  // namespace plinian::window
