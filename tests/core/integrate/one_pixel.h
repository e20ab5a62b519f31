// Scenes of one pixel: the picture is the radiance along the camera's axis.
#pragma once

#include <cmath>
#include <memory>

#include "core/scene/snapshot.h"

namespace plinian {

/// A scene seen along the ray from `eye` to `target`.
inline SceneSnapshot one_pixel(dvec3 eye, dvec3 target) {
  SceneSnapshot scene;
  const dvec3 forward = glm::normalize(target - eye);
  scene.camera = look_at(eye, target, std::abs(forward.y) > 0.9 ? dvec3(0, 0, 1) : dvec3(0, 1, 0), 40.0);
  scene.width = scene.height = 1;
  return scene;
}

inline Medium analytic_medium(MediumShape shape, vec3 sigma_s, vec3 sigma_a,
                              const dmat4& world_from_medium = dmat4(1.0)) {
  Medium medium;
  medium.shape = shape;
  medium.sigma_s = sigma_s;
  medium.sigma_a = sigma_a;
  medium.world_from_medium = world_from_medium;
  return medium;
}

inline Light sun(dvec3 toward, vec3 colour = vec3(1.0f)) {
  Light light;
  light.name = "sun";
  light.toward = vec3(glm::normalize(toward));
  light.colour = colour;
  return light;
}

/// A density given by f at the voxels [low, high], zero outside.
template <class F>
std::shared_ptr<const BrickVolume> voxels(ivec3 low, ivec3 high, F f,
                                          const dmat4& medium_from_index = dmat4(1.0)) {
  BrickVolumeBuilder builder;
  const auto block_of = [](int v) { return v >> 3; };
  for (int z = block_of(low.z); z <= block_of(high.z); ++z)
    for (int y = block_of(low.y); y <= block_of(high.y); ++y)
      for (int x = block_of(low.x); x <= block_of(high.x); ++x) {
        float values[BrickVolumeBuilder::block_voxels];
        for (int i = 0; i < BrickVolumeBuilder::block_voxels; ++i) {
          const ivec3 v = ivec3(x, y, z) * 8 + ivec3(i & 7, (i >> 3) & 7, i >> 6);
          const bool inside =
              glm::all(glm::greaterThanEqual(v, low)) && glm::all(glm::lessThanEqual(v, high));
          values[i] = inside ? f(v) : 0.0f;
        }
        builder.add({x, y, z}, values);
      }
  return std::make_shared<const BrickVolume>(builder.build(medium_from_index));
}

}  // namespace plinian

/// Expects a value within a relative error of the truth.
#define EXPECT_RELATIVE(found, truth, tolerance) EXPECT_NEAR(found, truth, (tolerance)*std::abs(truth))
