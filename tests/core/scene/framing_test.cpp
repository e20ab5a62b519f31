#include "core/scene/framing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/default_lights.h"
#include "core/shared/light_falloff.h"

namespace plinian {
namespace {

// Where a point lies in the picture: x, y in [-1, 1] where it is seen, z: its distance along the view.
dvec3 in_picture(const Camera& camera, dvec3 point, int width, int height) {
  const CameraRays rays = camera_rays(camera, width, height);
  const dvec3 x = normalize(dvec3(rays.right)), y = normalize(dvec3(rays.up)), z = cross(x, y);
  const dvec3 p = point - dvec3(camera.world_from_camera[3]);
  const double depth = -dot(p, z);
  const dvec3 centre = dvec3(rays.forward) * (1.0 / -dot(dvec3(rays.forward), z));
  return {(dot(p, x) / depth - dot(centre, x)) / length(dvec3(rays.right)),
          (dot(p, y) / depth - dot(centre, y)) / length(dvec3(rays.up)), depth};
}

Medium box(dvec3 centre, dvec3 half) {
  Medium medium;
  medium.shape = MediumShape::box;
  medium.world_from_medium =
      dmat4(dvec4(half.x, 0, 0, 0), dvec4(0, half.y, 0, 0), dvec4(0, 0, half.z, 0), dvec4(centre, 1));
  return medium;
}

TEST(Framing, FillsThePictureToTheMarginAndCutsNothingOff) {
  for (const dvec3 half : {dvec3(1, 1, 1), dvec3(10, 200, 10), dvec3(5, 0.1, 40), dvec3(1e-4, 2e-4, 1e-4)})
    for (const ivec2 size : {ivec2(512, 512), ivec2(1920, 800), ivec2(100, 700)})
      for (const vec2 offset : {vec2(0), vec2(6, -3)}) {
        const SceneBounds bounds = scene_bounds({box({30, -7, 2}, half)});
        Camera lens;
        lens.film_offset = offset;
        const Camera camera = frame_bounds(lens, bounds, 30, 10, size.x, size.y, 0.8);
        double widest = 0;
        for (const dvec3& point : bounds.outline) {
          const dvec3 p = in_picture(camera, point, size.x, size.y);
          EXPECT_GT(p.z, 0);
          widest = std::max({widest, std::abs(p.x), std::abs(p.y)});
        }
        EXPECT_NEAR(widest, 0.8, 1e-3) << half.y << " " << size.x << " " << offset.x;
      }
}

TEST(Framing, BoundsAreThoseOfTheOccupiedVoxelsUnderTheMediumsTransform) {
  BrickVolumeBuilder builder;
  std::vector<float> block(BrickVolumeBuilder::block_voxels, 0.0f);
  block[0] = 1.0f;
  builder.add({0, 0, 0}, block.data());
  builder.add({40, 0, 0}, block.data());
  Medium medium;
  medium.volume = std::make_shared<BrickVolume>(builder.build(dmat4(1.0)));
  medium.world_from_medium =
      dmat4(dvec4(0, 0, 2, 0), dvec4(0, 2, 0, 0), dvec4(2, 0, 0, 0), dvec4(0, 100, 0, 1));
  const SceneBounds bounds = scene_bounds({medium});
  // Voxels 0 and 320 along x; the trilinear support reaches one voxel further. x and z change places,
  // doubled.
  EXPECT_EQ(bounds.minimum, dvec3(-2, 98, -2));
  EXPECT_EQ(bounds.maximum, dvec3(2, 102, 642));
}

TEST(Framing, AnglesOfADirectionAreThoseItComesFrom) {
  for (const double elevation : {-80.0, 0.0, 35.0})
    for (const double azimuth : {-170.0, -30.0, 0.0, 90.0, 175.0}) {
      const SkyAngles angles = angles_of_direction(direction_from(azimuth, elevation) * 3.0, dvec3(1, 0, 0));
      EXPECT_NEAR(angles.azimuth, azimuth, 1e-9);
      EXPECT_NEAR(angles.elevation, elevation, 1e-9);
    }
  // Straight above, what is to the right tells the side: from +x, -z is to the right.
  const SkyAngles above = angles_of_direction(dvec3(0, 2, 0), dvec3(0, 0, -1));
  EXPECT_NEAR(above.azimuth, 90.0, 1e-9);
  EXPECT_EQ(above.elevation, 90.0);
}

TEST(Framing, ASceneWithoutAnyDensityIsFramedAsAUnitCube) {
  Medium empty;
  empty.volume = std::make_shared<BrickVolume>();
  EXPECT_EQ(scene_bounds({empty}).maximum, dvec3(1));
  EXPECT_NO_THROW(frame_bounds(Camera(), scene_bounds({}), 30, 0, 64, 64));
}

TEST(DefaultLights, TheKeyComesFromTheUpperSideAndTheRimFromBehindTheOther) {
  for (const double azimuth : {0.0, 30.0, 200.0}) {
    const Camera camera = frame_bounds(Camera(), scene_bounds({}), azimuth, 0, 64, 64);
    const vec3 right(dvec3(camera.world_from_camera[0])), back(dvec3(camera.world_from_camera[2]));
    const Light key = default_key(camera), rim = default_rim(camera);
    EXPECT_NEAR(glm::length(key.toward), 1.0f, 1e-6f);
    const double off_axis = glm::degrees(std::acos(glm::dot(key.toward, back)));
    EXPECT_GT(off_axis, 45.0);
    EXPECT_LT(off_axis, 70.0);
    EXPECT_GT(key.toward.y, 0.3f);
    EXPECT_GT(glm::dot(key.toward, right), 0.0f);
    EXPECT_LT(glm::dot(rim.toward, back), -0.4f);
    EXPECT_LT(glm::dot(rim.toward, right), -0.2f);
    EXPECT_NEAR(luminance(key.colour), 1.0f, 1e-5f);
  }
}

TEST(DefaultLights, ANewLightBringsTheKeysIrradianceToTheMiddleOfTheMedia) {
  const SceneBounds bounds = scene_bounds({box({10, 0, 0}, dvec3(2))});
  const float key = key_intensity * std::exp2(key_exposure);
  Light sun;
  sun.intensity = 3.0f;
  sun.colour = {2.0f, 2.0f, 2.0f};
  sun.exposure = new_light_exposure(sun, bounds);
  EXPECT_NEAR(luminance(sun.power()), key, 1e-4f * key);

  Light lamp;
  lamp.type = LightType::point;
  lamp.position = {10, 50, 0};
  for (const Falloff falloff : {Falloff::inverse_square, Falloff::linear, Falloff::none}) {
    lamp.falloff = falloff;
    lamp.exposure = 0.0f;
    lamp.exposure = new_light_exposure(lamp, bounds);
    const float arriving = luminance(lamp.power()) * shared::distance_falloff(int(falloff), 50.0f, 0.0f);
    EXPECT_NEAR(arriving, key, 1e-4f * key);
  }
  lamp.intensity = 0.0f;
  EXPECT_TRUE(std::isfinite(new_light_exposure(lamp, bounds)));
}

TEST(Framing, TellsOfAnExtentWithAsManyFiguresAsOneReads) {
  SceneBounds bounds;
  bounds.minimum = {-1.0502, 0.0, -1.0};
  bounds.maximum = {1.0498, 3.0, 1.0};
  EXPECT_EQ(extent_text(bounds), "2.1 x 3 x 2 m at (0, 1.5, 0)");
  bounds.minimum = {1000.0, 0.0, 0.0};
  bounds.maximum = {13345.6, 2.0, 4000.0};
  EXPECT_EQ(extent_text(bounds), "12300 x 2 x 4000 m at (7200, 0, 2000)");
}

}  // namespace
}  // namespace plinian
