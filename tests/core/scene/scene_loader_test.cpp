#include "core/scene/scene_loader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/media/vdb_writer.h"
#include "core/scene/default_lights.h"
#include "core/scene/scene_file.h"
#include "tests/core/scene/temporary_folder.h"

namespace plinian {
namespace {

LoadedScene load(const std::string& text) {
  TemporaryFolder folder;
  return load_scene(read_scene_file(folder.write("scene.json", text)));
}

bool told(const std::vector<std::string>& lines, const std::string& part) {
  for (const std::string& line : lines)
    if (line.find(part) != std::string::npos) return true;
  return false;
}

// A slab of even density, half a metre per voxel, hot at one end where asked.
std::shared_ptr<const BrickVolume> slab(bool hot) {
  BrickVolumeBuilder builder;
  const std::vector<float> density(BrickVolumeBuilder::block_voxels, 0.5f);
  std::vector<float> temperature(BrickVolumeBuilder::block_voxels, 1500.0f);
  for (int x = 0; x < 4; ++x) builder.add({x, 0, 0}, density.data(), hot ? temperature.data() : nullptr);
  return std::make_shared<BrickVolume>(builder.build(dmat4(glm::dmat3(0.5))));
}

TEST(SceneLoader, ReadsANeutralSceneToTheLetter) {
  const LoadedScene loaded =
      load(R"({"volume": "box", "density_scale": 4, "albedo": [0.8, 0.6, 0.4], "g": 0.3,
    "camera": {"eye": [0, 0, 10], "target": [0, 0, 0], "up": [0, 1, 0], "fov_y_degrees": 36},
    "lights": [{"type": "directional", "toward": [0, 3, 4], "irradiance": [12, 6, 3]}], "size": [200, 100]})");
  const SceneSnapshot& s = loaded.snapshot;
  EXPECT_EQ(s.width, 200);
  EXPECT_EQ(s.media[0].density_scale, 4.0f);
  EXPECT_NEAR(s.media[0].sigma_s.y, 0.6f, 1e-6f);
  EXPECT_NEAR(s.media[0].sigma_a.y, 0.4f, 1e-6f);
  EXPECT_EQ(s.media[0].phase.kind, PhaseKind::henyey_greenstein);
  EXPECT_NEAR(s.lights[0].toward.y, 0.6f, 1e-6f);
  EXPECT_NEAR(glm::length(s.lights[0].power() - vec3(12, 6, 3)), 0.0f, 1e-5f);
  EXPECT_EQ(s.ambient, vec3(0.0f));
  EXPECT_EQ(s.background, vec3(0.0f));
  const CameraRays rays = camera_rays(s.camera, 200, 100);
  EXPECT_NEAR(glm::length(rays.up), std::tan(glm::radians(18.0)), 1e-6);
  EXPECT_EQ(rays.origin, vec3(0, 0, 10));
  EXPECT_TRUE(loaded.notes.empty()) << loaded.notes[0];
}

TEST(SceneLoader, PlacesAMediumScaledThenTurnedThenMoved) {
  const LoadedScene loaded = load(R"({"volume": "box", "scale": [2, 1, 1], "rotate": [0, 0, 90],
                                      "translate": [10, 0, 0]})");
  const dvec3 end(loaded.snapshot.media[0].world_from_medium * dvec4(1, 0, 0, 1));
  EXPECT_NEAR(glm::length(end - dvec3(10, 2, 0)), 0.0, 1e-12);
}

TEST(SceneLoader, KeepsExtinctionOrOpticalDepthWhenAVolumeIsScaled) {
  const auto scale = [](const char* rescale) {
    return load(std::string(R"({"volume": "box", "scale": 2, "density_scale": 3, "rescale": ")") + rescale +
                "\"}")
        .snapshot.media[0]
        .density_scale;
  };
  EXPECT_FLOAT_EQ(scale("extinction"), 3.0f);
  EXPECT_FLOAT_EQ(scale("optical_depth"), 1.5f);
}

TEST(SceneLoader, TurnsACameraAsMayaDoes) {
  const LoadedScene loaded = load(
      R"({"volume": "box", "camera": {"translate": [1, 2, 3], "rotate": [-30, 90, 0], "focal_length": 50}})");
  const CameraRays rays = camera_rays(loaded.snapshot.camera, 100, 100);
  EXPECT_EQ(rays.origin, vec3(1, 2, 3));
  // About y first points along -x, then tilted down by 30 degrees in that direction.
  EXPECT_NEAR(glm::length(rays.forward - vec3(-std::sqrt(0.75f), -0.5f, 0)), 0.0f, 1e-6f);
  EXPECT_EQ(loaded.snapshot.camera.focal_length, 50.0f);
}

TEST(SceneLoader, SpotsPointAtTheMediaAndNewLightsStartAtTheKeysIrradiance) {
  const LoadedScene loaded = load(R"({"volume": "sphere", "translate": [0, 5, 0], "lights": [
    {"type": "spot", "position": [0, 5, 20]}, {"type": "directional", "toward": [0, 1, 0]},
    {"type": "point", "position": [0, 9, 0], "intensity": 3}]})");
  const auto& lights = loaded.snapshot.lights;
  EXPECT_NEAR(glm::length(lights[0].toward - vec3(0, 0, 1)), 0.0f, 1e-6f);
  const float key = key_intensity * std::exp2(key_exposure);
  EXPECT_NEAR(lights[0].power().x / 400.0f, key, 1e-2f * key);
  EXPECT_NEAR(lights[1].power().x, key, 1e-3f * key);
  EXPECT_EQ(lights[2].power().x, 3.0f);
  EXPECT_TRUE(told(loaded.notes, "light0: exposure"));
}

TEST(SceneLoader, ABareVolumeIsOrientedScaledFramedAndLitAndSaysSo) {
  TemporaryFolder folder;
  write_vdb(folder / "slab.vdb", *slab(false), {.up_axis = 'z', .file_unit = 0.01});
  const LoadedScene loaded = load_scene(describe_input(folder / "slab.vdb"));
  const Medium& medium = loaded.snapshot.media[0];
  // z of the file is up, and 16 units of a centimetre are 16 cm.
  EXPECT_NEAR(glm::length(dvec3(medium.world_from_medium * dvec4(0, 0, 1, 0)) - dvec3(0, 0.01, 0)), 0.0,
              1e-9);
  EXPECT_EQ(loaded.snapshot.lights.size(), 2u);
  EXPECT_EQ(loaded.snapshot.ambient, default_ambient);
  EXPECT_TRUE(told(loaded.notes, "--up-axis"));
  EXPECT_TRUE(told(loaded.notes, "mean free path"));
  EXPECT_TRUE(told(loaded.notes, "camera: placed"));
  // Opaque, but no cut-out: 8 voxels of 5 mm, seen along two of three axes, hold an optical depth around 12.
  const float across = 0.04f * 0.5f * medium.density_scale;
  EXPECT_GT(across, 6.0f);
  EXPECT_LT(across, 24.0f);
}

TEST(SceneLoader, AFileInASceneKeepsItsOwnSpaceUnlessTold) {
  TemporaryFolder folder;
  write_vdb(folder / "slab.vdb", *slab(true), {.up_axis = 'z', .file_unit = 0.01});
  const auto medium = [&](const std::string& more) {
    return load_scene(read_scene_file(folder.write(
                          "s.json", R"({"volume": "slab.vdb", "density_scale": 1)" + more + "}")))
        .snapshot.media[0];
  };
  EXPECT_EQ(medium("").world_from_medium, dmat4(1.0));
  EXPECT_NE(medium(R"(, "up_axis": "z")").world_from_medium, dmat4(1.0));
  EXPECT_TRUE(medium("").volume->temperature.empty()) << "a scene that names no temperature does not glow";
  EXPECT_EQ(medium("").emission.scale, 0.0f);
  EXPECT_FALSE(medium(R"(, "emission_scale": 2)").volume->temperature.empty());
  EXPECT_EQ(medium(R"(, "emission_scale": 2)").emission.scale, 2.0f);
  EXPECT_EQ(medium(R"(, "temperature_grid": "temperature")").emission.scale, 1.0f);
}

TEST(SceneLoader, ABareHotVolumeGlowsAndItsTemperatureCanBeScaled) {
  TemporaryFolder folder;
  write_vdb(folder / "hot.vdb", *slab(true));
  SceneDescription scene = describe_input(folder / "hot.vdb");
  EXPECT_EQ(load_scene(scene).snapshot.media[0].emission.scale, 1.0f);
  set_scene_value(scene, "medium.temperature_scale", "2");
  set_scene_value(scene, "medium.temperature_offset", "100");
  const Emission emission = load_scene(scene).snapshot.media[0].emission;
  EXPECT_EQ(emission.temperature_scale, 2.0f);
  EXPECT_EQ(emission.temperature_offset, 100.0f);
}

TEST(SceneLoader, AProceduralMediumKeepsItsOwnLookUnlessTold) {
  const LoadedScene plain = load(R"({"volume": "ash", "resolution": 16, "seed": 5})");
  const LoadedScene edited = load(R"({"volume": "ash", "resolution": 16, "seed": 5, "albedo": 0.25})");
  const Medium &a = plain.snapshot.media[0], &b = edited.snapshot.media[0];
  EXPECT_EQ(plain.seed, 5);
  EXPECT_GT(a.density_scale, 0.0f);
  EXPECT_EQ(a.density_scale, b.density_scale);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(b.sigma_s[i] + b.sigma_a[i], a.sigma_s[i] + a.sigma_a[i], 1e-6f)
        << "an albedo edit keeps extinction";
    EXPECT_NEAR(b.sigma_s[i], 0.25f * (a.sigma_s[i] + a.sigma_a[i]), 1e-6f);
  }
}

TEST(SceneLoader, CanBeCancelled) {
  SceneLoadOptions options;
  options.progress = [](double) { return false; };
  SceneDescription scene = describe_input("ash");
  set_scene_value(scene, "medium.resolution", "64");
  EXPECT_THROW(load_scene(scene, options), SceneLoadCancelled);
}

TEST(SceneLoader, AnEmptyVolumeIsASaneSceneAndAWarning) {
  TemporaryFolder folder;
  write_vdb(folder / "empty.vdb", BrickVolume());
  const LoadedScene loaded = load_scene(describe_input(folder / "empty.vdb"));
  EXPECT_FALSE(loaded.warnings.empty());
  EXPECT_TRUE(std::isfinite(loaded.snapshot.media[0].density_scale));
  EXPECT_TRUE(std::isfinite(loaded.snapshot.camera.world_from_camera[3].z));
}

TEST(SceneLoader, TurnsTheDefaultKeyIntoALampThatLightsAsMuch) {
  SceneDescription description = describe_input("box");
  set_scene_value(description, "key.type", "spot");
  set_scene_value(description, "key.position", "0,30,40");
  const LoadedScene loaded = load_scene(description);
  const Light& lamp = loaded.snapshot.lights[0];
  ASSERT_EQ(lamp.name, "key");
  // 50 m away, by the inverse square.
  const float arriving = luminance(lamp.colour) * lamp.intensity * std::exp2(lamp.exposure) / 2500.0f;
  EXPECT_NEAR(arriving, key_intensity * std::exp2(key_exposure), 0.01f * arriving);
  EXPECT_TRUE(told(loaded.notes, "exposure"));
}

}  // namespace
}  // namespace plinian
