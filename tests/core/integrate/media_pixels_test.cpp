// No pixel that may show a medium lies outside the box that is rendered.
#include "core/integrate/media_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/shared/view_march.h"

namespace plinian {
namespace {

constexpr int width = 320, height = 200;

Medium box_at(dvec3 place, double size) {
  Medium box;
  box.shape = MediumShape::box;
  box.world_from_medium = dmat4(size);
  box.world_from_medium[3] = dvec4(place, 1.0);
  return box;
}

PixelBox pixels_of(const std::vector<Medium>& media, const Camera& camera) {
  SceneSnapshot scene;
  scene.media = media;
  return media_pixels(flatten(scene), camera, width, height);
}

TEST(MediaPixels, HoldEveryRayThatMeetsAMediumAndLittleElse) {
  const std::vector<Medium> media = {box_at({-1.0, 0.5, 0.0}, 0.4), box_at({0.3, -0.2, -2.0}, 0.3)};
  const Camera camera = look_at({1.0, 0.7, 6.0}, {0.0, 0.1, 0.0}, {0, 1, 0}, 40.0);
  const PixelBox box = pixels_of(media, camera);
  const CameraRays rays = camera_rays(camera, width, height);
  ivec2 low(width, height), high(0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const Medium& medium : media) {
        const vec3 direction =
            shared::pixel_direction(rays.forward, rays.right, rays.up, {x, y}, {width, height});
        const float size = float(medium.world_from_medium[0][0]);
        const vec3 from = (rays.origin - vec3(medium.world_from_medium[3])) / size;
        const vec3 a = (vec3(-1.0f) - from) / direction, b = (vec3(1.0f) - from) / direction;
        const vec3 enter = glm::min(a, b), leave = glm::max(a, b);
        if (std::max({enter.x, enter.y, enter.z}) > std::min({leave.x, leave.y, leave.z})) continue;
        low = glm::min(low, ivec2(x, y));
        high = glm::max(high, ivec2(x, y) + 1);
      }
  const ivec2 end = box.first + box.size;
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_LE(box.first[axis], low[axis]);
    EXPECT_GE(end[axis], high[axis]);
    EXPECT_GE(box.first[axis], low[axis] - 3);
    EXPECT_LE(end[axis], high[axis] + 3);
  }
}

TEST(MediaPixels, AreAllWhereAMediumReachesTheCamera) {
  const Camera camera = look_at({0.0, 0.0, 6.0}, {0.0, 0.0, 0.0}, {0, 1, 0}, 40.0);
  for (const Medium& around : {box_at({0, 0, 6}, 1.0), box_at({5, 0, 5.9}, 1.0), box_at({0, 0, 0}, 100.0)}) {
    const PixelBox box = pixels_of({box_at({0, 0, 0}, 0.5), around}, camera);
    EXPECT_EQ(box.first, ivec2(0));
    EXPECT_EQ(box.size, ivec2(width, height));
  }
}

TEST(MediaPixels, AreNoneWhereTheMediaLieBesideThePicture) {
  const Camera camera = look_at({0.0, 0.0, 6.0}, {0.0, 0.0, 0.0}, {0, 1, 0}, 40.0);
  EXPECT_TRUE(pixels_of({box_at({30.0, 0.0, 0.0}, 1.0)}, camera).empty());
}

}  // namespace
}  // namespace plinian
