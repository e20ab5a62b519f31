#include "core/scene/scene_hash.h"

#include <gtest/gtest.h>

#include <vector>

namespace plinian {
namespace {

std::shared_ptr<const BrickVolume> ball(float density) {
  BrickVolumeBuilder builder;
  std::vector<float> block(BrickVolumeBuilder::block_voxels, density);
  for (int z = -2; z < 2; ++z)
    for (int y = -2; y < 2; ++y)
      for (int x = -2; x < 2; ++x) {
        block[0] = density * float(1 + x * x + 2 * y + 3 * z * z) * 0.05f;
        builder.add({x, y, z}, block.data());
      }
  return std::make_shared<BrickVolume>(builder.build(dmat4(1.0)));
}

SceneSnapshot some_scene() {
  SceneSnapshot scene;
  scene.media.push_back({.volume = ball(1.0f)});
  scene.lights.push_back({.name = "key"});
  return scene;
}

TEST(SceneHash, IsTheSameForTheSameSceneMadeAgain) {
  EXPECT_EQ(scene_hash(some_scene()), scene_hash(some_scene()));
  EXPECT_EQ(scene_hash_text(some_scene()).size(), 16u);
  // A literal, so that a hash written into a file today is found again tomorrow.
  EXPECT_EQ(scene_hash_text(SceneSnapshot{}), "513ed480a44ff40a");
}

TEST(SceneHash, LeavesOutQualityAndNames) {
  SceneSnapshot scene = some_scene();
  scene.quality.map.coefficients = 14;
  scene.quality.name = "high";
  scene.media[0].name = "plume";
  scene.lights[0].name = "sun";
  EXPECT_EQ(scene_hash(scene), scene_hash(some_scene()));
}

TEST(SceneHash, ChangesWithEverythingThatShows) {
  const std::vector<void (*)(SceneSnapshot&)> edits = {
      [](SceneSnapshot& s) { s.camera.world_from_camera[3].x += 0.001; },
      [](SceneSnapshot& s) { s.camera.focal_length = 36.0f; },
      [](SceneSnapshot& s) { s.camera.fit = FilmFit::vertical; },
      [](SceneSnapshot& s) { s.camera.near_clip = 1.0f; },
      [](SceneSnapshot& s) { s.width = 511; },
      [](SceneSnapshot& s) { s.ambient.y = 0.1f; },
      [](SceneSnapshot& s) { s.background.z = 0.1f; },
      [](SceneSnapshot& s) { s.media[0].density_scale = 1.0001f; },
      [](SceneSnapshot& s) { s.media[0].sigma_s.x = 0.7f; },
      [](SceneSnapshot& s) { s.media[0].sigma_a.z = 0.3f; },
      [](SceneSnapshot& s) { s.media[0].phase.g = 0.1f; },
      [](SceneSnapshot& s) { s.media[0].emission.scale = 1.0f; },
      [](SceneSnapshot& s) { s.media[0].world_from_medium[1].y = -1.0; },
      [](SceneSnapshot& s) { s.media[0].volume = ball(1.1f); },
      [](SceneSnapshot& s) { s.media[0].shape = MediumShape::box; },
      [](SceneSnapshot& s) { s.media.push_back({.shape = MediumShape::sphere}); },
      [](SceneSnapshot& s) { s.media.clear(); },
      [](SceneSnapshot& s) { s.lights.clear(); },
      [](SceneSnapshot& s) { s.lights[0].exposure = 1.0f; },
      [](SceneSnapshot& s) {
        s.lights[0].toward = {1.0f, 0.0f, 0.0f};
      },
      [](SceneSnapshot& s) { s.lights[0].type = LightType::point; },
      [](SceneSnapshot& s) {
        // One voxel in the last place that a volume's voxels differ.
        auto volume = std::make_shared<BrickVolume>(*s.media[0].volume);
        volume->density.back() ^= 1;
        s.media[0].volume = volume;
      },
  };
  std::vector<std::uint64_t> hashes = {scene_hash(some_scene())};
  for (const auto& edit : edits) {
    SceneSnapshot scene = some_scene();
    edit(scene);
    const std::uint64_t hash = scene_hash(scene);
    EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hash), 0) << "edit " << hashes.size();
    hashes.push_back(hash);
  }
}

}  // namespace
}  // namespace plinian
