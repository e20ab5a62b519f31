#include "core/lights/light_frame.h"

#include <gtest/gtest.h>

#include <random>

#include "core/shared/light_march.h"

namespace plinian {
namespace {

Corners cube(dvec3 centre, double half) {
  Corners corners;
  for (int c = 0; c < 8; ++c)
    corners.push_back(centre + dvec3(c & 1 ? half : -half, c & 2 ? half : -half, c & 4 ? half : -half));
  return corners;
}

/// u, v, k of a point, as decode_map() finds them.
vec3 project(const MapData& map, vec3 p) {
  const auto row = [&](vec4 r) { return glm::dot(vec3(r), p) + r.w; };
  const vec3 q(row(map.row_u), row(map.row_v), row(map.row_k));
  if (map.projection == projection_orthographic) return q;
  return {0.5f + q.x / q.z, 0.5f + q.y / q.z, glm::length(p - map.ray_origin)};
}

/// The point at distance k along the ray of (u, v), as encode_texel() walks it.
vec3 along_ray(const MapData& map, vec2 uv, float k) {
  MarchScene scene;
  scene.maps = &map;
  return shared::map_ray_origin(scene, 0, uv) + k * shared::map_ray_direction(scene, 0, uv);
}

TEST(LightFrame, RaysAndProjectionAreInversesForEveryKindOfLight) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.02f, 0.98f);
  for (const LightType type : {LightType::directional, LightType::spot, LightType::point}) {
    Light light;
    light.type = type;
    light.toward = glm::normalize(vec3(0.3f, 0.8f, -0.4f));
    light.position = {5, 9, -4};
    for (const MapData& map : light_frames(light, cube({1, 2, 3}, 2.0), 128))
      for (int i = 0; i < 50; ++i) {
        const vec2 uv(unit(random), unit(random));
        const float k = map.k_max * unit(random);
        const vec3 back = project(map, along_ray(map, uv, k));
        EXPECT_NEAR(back.x, uv.x, 1e-4f);
        EXPECT_NEAR(back.y, uv.y, 1e-4f);
        EXPECT_NEAR(back.z, k, 1e-4f * map.k_max);
      }
  }
}

TEST(LightFrame, ADirectionalFrameHoldsTheMediaWithKFromItsNearPlane) {
  Light light;
  light.toward = glm::normalize(vec3(-0.7f, 0.2f, 0.6f));
  const Corners corners = cube({4, -1, 2}, 3.0);
  const MapData map = light_frames(light, corners, 256).at(0);
  for (const dvec3& c : corners) {
    const vec3 q = project(map, vec3(c));
    EXPECT_GT(q.x, 0.5f / 256);
    EXPECT_LT(q.x, 1 - 0.5f / 256);
    EXPECT_GT(q.y, 0.5f / 256);
    EXPECT_LT(q.y, 1 - 0.5f / 256);
    EXPECT_GE(q.z, -1e-4f);
    EXPECT_LE(q.z, map.k_max);
  }
}

TEST(LightFrame, TexelsDoNotSwimWhileTheMediaMove) {
  Light light;
  light.toward = glm::normalize(vec3(0.2f, 1.0f, 0.3f));
  const int size = 256;
  const MapData still = light_frames(light, cube({0, 0, 0}, 2.0), size).at(0);
  const MapData moved = light_frames(light, cube({0.1234, 0.05, -0.21}, 2.0), size).at(0);
  EXPECT_EQ(glm::length(still.ray_u), glm::length(moved.ray_u));
  const vec3 p(0.3f, 0.1f, 0.2f);
  const vec3 shift = (project(still, p) - project(moved, p)) * float(size);
  EXPECT_NEAR(shift.x, std::round(shift.x), 2e-2f);
  EXPECT_NEAR(shift.y, std::round(shift.y), 2e-2f);
}

TEST(LightFrame, EveryDirectionFromAPointLightIsSeenByOneFace) {
  Light light;
  light.type = LightType::point;
  light.position = {1, 2, 3};
  const auto faces = light_frames(light, cube({0, 0, 0}, 5.0), 64);
  ASSERT_EQ(faces.size(), 6u);
  LightData data{};
  data.faces = 6;
  data.position = light.position;
  std::mt19937 random(9);
  std::normal_distribution<float> gauss;
  for (int i = 0; i < 500; ++i) {
    const vec3 p = light.position + 4.0f * glm::normalize(vec3(gauss(random), gauss(random), gauss(random)));
    const vec3 d = glm::abs(p - light.position);
    const int axis = d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
    const vec3 q = project(faces[axis * 2 + ((p - light.position)[axis] < 0 ? 1 : 0)], p);
    EXPECT_GE(q.x, 0.0f);
    EXPECT_LE(q.x, 1.0f);
    EXPECT_GE(q.y, 0.0f);
    EXPECT_LE(q.y, 1.0f);
  }
}

}  // namespace
}  // namespace plinian
