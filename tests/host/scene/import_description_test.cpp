// A description made into nodes is the scene that core's own loader makes of it, to the bit.
#include <random>
#include <thread>

#include "core/media/vdb_writer.h"
#include "core/scene/medium_loader.h"
#include "core/scene/placement_angles.h"
#include "core/scene/scene_loader.h"
#include "host/scene/medium_names.h"
#include "tests/host/scene/test_workspace.h"

namespace plinian::scene {
namespace {

void expect_same_light(const Light& a, const Light& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.type, b.type);
  if (a.type != LightType::point) {
    EXPECT_EQ(a.toward, b.toward) << a.name;
  }
  EXPECT_EQ(a.position, b.position) << a.name;
  EXPECT_EQ(a.colour, b.colour) << a.name;
  EXPECT_EQ(a.intensity, b.intensity) << a.name;
  EXPECT_EQ(a.exposure, b.exposure) << a.name;
  EXPECT_EQ(a.falloff, b.falloff) << a.name;
  EXPECT_EQ(a.radius, b.radius) << a.name;
  EXPECT_EQ(a.cone_angle, b.cone_angle) << a.name;
  EXPECT_EQ(a.penumbra, b.penumbra) << a.name;
}

void expect_same_medium(const Medium& a, const Medium& b) {
  EXPECT_EQ(a.shape, b.shape);
  EXPECT_EQ(a.world_from_medium, b.world_from_medium);
  EXPECT_EQ(a.density_scale, b.density_scale);
  EXPECT_EQ(a.sigma_s, b.sigma_s);
  // 1 - 0.8 is not quite 0.2; what light meets is the sum.
  EXPECT_EQ(a.sigma_s + a.sigma_a, b.sigma_s + b.sigma_a);
  EXPECT_NEAR(glm::length(a.sigma_a - b.sigma_a), 0.0f, 3e-8f);
  EXPECT_EQ(a.phase.kind, b.phase.kind);
  EXPECT_EQ(a.phase.g, b.phase.g);
  EXPECT_EQ(a.phase.g_back, b.phase.g_back);
  EXPECT_EQ(a.phase.blend, b.phase.blend);
  EXPECT_EQ(a.emission.scale, b.emission.scale);
  EXPECT_EQ(a.emission.exposure, b.emission.exposure);
  EXPECT_EQ(a.emission.temperature_scale, b.emission.temperature_scale);
  EXPECT_EQ(a.emission.temperature_offset, b.emission.temperature_offset);
  ASSERT_EQ(bool(a.volume), bool(b.volume));
  if (!a.volume) return;
  EXPECT_EQ(a.volume->density, b.volume->density);
  EXPECT_EQ(a.volume->temperature, b.volume->temperature);
  EXPECT_EQ(a.volume->medium_from_index, b.volume->medium_from_index);
}

// What a picture shows of a camera: its rays, as floats.
void expect_same_camera(const SceneSnapshot& a, const SceneSnapshot& b) {
  const CameraRays x = camera_rays(a.camera, a.width, a.height), y = camera_rays(b.camera, b.width, b.height);
  EXPECT_EQ(x.origin, y.origin);
  for (const auto& [u, v] :
       {std::pair(x.forward, y.forward), std::pair(x.right, y.right), std::pair(x.up, y.up)})
    EXPECT_NEAR(glm::length(u - v), 0.0f, 1e-15f) << "rays differ";
  EXPECT_EQ(a.camera.focal_length, b.camera.focal_length);
  EXPECT_EQ(a.camera.film_back, b.camera.film_back);
  EXPECT_EQ(a.camera.fit, b.camera.fit);
  EXPECT_EQ(a.camera.near_clip, b.camera.near_clip);
}

void expect_same(const SceneDescription& description) {
  TestWorkspace w;
  const ImportReport report = import_description(w.session(), description);
  const LoadedScene expected = load_scene(description);
  const SceneSnapshot built = w.snapshot(), &wanted = expected.snapshot;
  EXPECT_EQ(built.width, wanted.width);
  EXPECT_EQ(built.height, wanted.height);
  EXPECT_EQ(built.ambient, wanted.ambient);
  EXPECT_EQ(built.background, wanted.background);
  expect_same_camera(built, wanted);
  ASSERT_EQ(built.media.size(), wanted.media.size());
  for (std::size_t i = 0; i < built.media.size(); ++i) expect_same_medium(built.media[i], wanted.media[i]);
  ASSERT_EQ(built.lights.size(), wanted.lights.size());
  for (std::size_t i = 0; i < built.lights.size(); ++i) expect_same_light(built.lights[i], wanted.lights[i]);
  EXPECT_EQ(report.notes, expected.notes);
  EXPECT_EQ(report.warnings, expected.warnings);
  EXPECT_EQ(report.seed, expected.seed);
}

SceneDescription described(const TemporaryFolder& folder, const std::string& text) {
  return read_scene_file(folder.write("scene.json", text));
}

TEST(ImportDescription, AProceduralMediumUnderDefaultLights) {
  for (const char* kind : {"ash", "cloud", "sandstorm", "explosion", "box", "sphere"}) {
    SCOPED_TRACE(kind);
    SceneDescription description = small_scene(kind);
    expect_same(description);
    set_scene_value(description, "medium.albedo", "0.3,0.5,0.7");
    set_scene_value(description, "medium.g", "0.6");
    set_scene_value(description, "camera.azimuth", "200");
    expect_same(description);
  }
}

TEST(ImportDescription, BareFilesAreOrientedAndScaled) {
  TemporaryFolder folder;
  BrickVolumeBuilder builder;
  const std::vector<float> density(BrickVolumeBuilder::block_voxels, 0.5f),
      temperature(BrickVolumeBuilder::block_voxels, 1500.0f);
  for (int x = 0; x < 4; ++x) builder.add({x, 0, 0}, density.data(), temperature.data());
  write_vdb(folder / "hot.vdb", builder.build(dmat4(glm::dmat3(0.5))), {.up_axis = 'z', .file_unit = 0.01});
  SceneDescription description = describe_input(folder / "hot.vdb");
  expect_same(description);
  set_scene_value(description, "medium.up_axis", "y");
  set_scene_value(description, "medium.temperature_scale", "2");
  expect_same(description);
  set_scene_value(description, "medium.file_unit", "0.3");
  set_scene_value(description, "medium.rescale", "optical_depth");
  expect_same(description);
  write_vdb(folder / "empty.vdb", BrickVolume());
  expect_same(describe_input(folder / "empty.vdb"));
}

TEST(ImportDescription, SeveralMediaAndAllKindsOfLights) {
  TemporaryFolder folder;
  expect_same(described(folder, R"({"media": [
      {"name": "ball", "volume": "sphere", "translate": [0, 5, 0], "rotate": [10, 20, 90], "scale": [1, 2, -3],
       "sigma_s": [0.1, 0.2, 0.3], "sigma_a": 0.7, "phase": "two_lobe", "g": 0.8, "g_back": -0.3, "blend": 0.2},
      {"volume": "ash", "resolution": 16, "seed": 5, "shape": {"veils": 1.5}, "extinction": [1, 2, 0],
       "emission_scale": 0.5, "emission_exposure": 1, "temperature_offset": 30}],
    "camera": {"eye": [3, 4, 10], "target": [0, 2, 0], "up": [0.2, 1, 0], "film_fit": "overscan", "near_clip": 0.5,
               "focal_length": 50, "film_offset": [1, -2], "pixel_aspect": 2},
    "lights": [
      {"type": "directional", "toward": [0, 1, 0], "irradiance": [12, 6, 3]},
      {"type": "directional", "name": "sun", "toward": [0.3, 0.7, -0.2], "kelvin": 3000, "intensity": 2},
      {"type": "spot", "position": [0, 5, 20], "cone_angle": 30, "penumbra": 2, "falloff": "linear"},
      {"type": "point", "position": [1, 9, 0.1], "intensity": 3, "radius": 0.25, "colour": [1, 0.5, 0.1]}],
    "ambient": [0.1, 0.2, 0.3], "background": 0.05, "size": [200, 100]})"));
  expect_same(
      described(folder, R"({"volume": "box", "camera": {"translate": [1, 2, 3], "rotate": [-30, 90, 15],
    "fov_y_degrees": 36}, "lights": []})"));
}

TEST(ImportDescription, RealFilesAreWhatTheyWere) {
  const std::string shared = std::string(PLINIAN_SOURCE_DIR) + "/../shared/";
  if (!std::filesystem::exists(shared + "data/smoke.vdb")) GTEST_SKIP() << shared << " is not there";
  for (const char* file : {"data/smoke.vdb", "data/densityAndHeat.vdb", "data/smoke_000002.vdb",
                           "peers/scenes/smoke-dense.json"}) {
    SCOPED_TRACE(file);
    expect_same(describe_input(shared + file));
  }
}

TEST(ImportDescription, DirectionsOutliveTheTurnIntoAngles) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int missed = 0;
  for (int i = 0; i < 20000; ++i) {
    dvec3 direction(normal(random), normal(random), normal(random));
    if (i % 4 == 0) direction[i / 4 % 3] *= 1e-6;
    const vec3 toward(glm::normalize(direction));
    const dmat4 turned = rotation_xyz(angles_toward(direction_of(toward)));
    // A component that is next to nothing may lose its last bits.
    if (i % 4 == 0) {
      EXPECT_LT(glm::length(dvec3(turned[2]) - direction_of(toward)), 1e-15);
    } else {
      missed += vec3(dvec3(turned[2])) != toward;
    }
  }
  EXPECT_EQ(missed, 0);
}

TEST(ImportDescription, ASequenceIsSetUpOnceByItsFirstFrameThatShowsAnything) {
  TemporaryFolder folder;
  write_vdb(folder / "s.1.vdb", BrickVolume());
  for (const int frame : {2, 3}) {
    BrickVolumeBuilder builder;
    const std::vector<float> voxels(BrickVolumeBuilder::block_voxels, float(frame));
    for (int x = 0; x < frame; ++x) builder.add({x, 0, 0}, voxels.data());
    write_vdb(folder / ("s." + std::to_string(frame) + ".vdb"), builder.build(dmat4(1.0)));
  }
  TestWorkspace w;
  const ImportReport report = import_description(w.session(), describe_input(folder / "s.#.vdb"));
  EXPECT_EQ(report.notes.front(),
            "3 frames, 1 to 3; set up by frame 2, the first that shows anything; the camera shows frame 3 as "
            "well");
  const SceneSnapshot second = w.snapshot();
  EXPECT_EQ(second.media[0].density_scale,
            load_scene(describe_input(folder / "s.2.vdb")).snapshot.media[0].density_scale);
  w.run("currentTime 3");
  const SceneSnapshot third = w.snapshot();
  EXPECT_EQ(third.media[0].volume->density_max, 3.0f);
  EXPECT_EQ(third.media[0].density_scale, second.media[0].density_scale);
  EXPECT_EQ(third.camera.world_from_camera, second.camera.world_from_camera);
  w.run("currentTime 1");
  EXPECT_TRUE(w.snapshot().media[0].volume->empty());
}

TEST(ImportDescription, ASequenceThatGrowsStaysInThePicture) {
  TemporaryFolder folder;
  for (const int frame : {1, 2, 3, 4, 5}) {
    BrickVolumeBuilder builder;
    const std::vector<float> voxels(BrickVolumeBuilder::block_voxels, 1.0f);
    for (int y = 0; y < frame; ++y) builder.add({0, y, 0}, voxels.data());
    write_vdb(folder / ("s." + std::to_string(frame) + ".vdb"), builder.build(dmat4(1.0)));
  }
  TestWorkspace w;
  import_description(w.session(), describe_input(folder / "s.#.vdb"));
  EXPECT_EQ(w.run("currentTime"), "1");
  for (const int frame : {1, 3, 5}) {
    w.run("currentTime " + std::to_string(frame));
    const SceneSnapshot s = w.snapshot();
    const CameraRays rays = camera_rays(s.camera, s.width, s.height);
    for (const dvec3& point : scene_bounds(s.media).outline) {
      const dvec4 seen = glm::inverse(s.camera.world_from_camera) * dvec4(point, 1.0);
      EXPECT_LT(std::abs(seen.x / seen.z), rays.right.x) << frame;
      EXPECT_LT(std::abs(seen.y / seen.z), rays.up.y) << frame;
    }
  }
}

TEST(ImportDescription, BadInputIsRefusedBeforeAnythingIsMade) {
  TestWorkspace w;
  const std::string before = w.run("ls");
  EXPECT_EQ(error_of([&] { import_description(w.session(), describe_input("nowhere/s.vdb")); }),
            "nowhere/s.vdb: no such file");
  EXPECT_EQ(error_of([&] { import_description(w.session(), describe_input("nowhere/s.#.vdb")); }),
            "nowhere/s.#.vdb: no file of that sequence is there");
  EXPECT_EQ(w.run("ls"), before);
  SceneDescription cancelled = small_scene();
  set_scene_value(cancelled, "medium.resolution", "128");
  EXPECT_THROW(import_description(w.session(), cancelled, {.progress = [](double) { return false; }}),
               SceneLoadCancelled);
}

// Whoever draws a window is asked while a volume is measured too, on the thread that imports.
TEST(ImportDescription, CancelledWhileAVolumeIsMeasuredLeavesTheSceneAsItWas) {
  TestWorkspace w;
  const std::string before = w.run("ls");
  const auto here = std::this_thread::get_id();
  double highest = 0.0;
  const auto progress = [&](double share) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    EXPECT_GE(share, highest);
    highest = share;
    return share < 0.9;
  };
  const auto import = [&] {
    const graph::History::Scope scope(w.session().history(), "import");
    import_description(w.session(), small_scene(), {.progress = progress});
  };
  EXPECT_THROW(import(), SceneLoadCancelled);
  EXPECT_GE(highest, 0.9) << "it was asked after reading";
  EXPECT_EQ(w.run("ls"), before);
  EXPECT_TRUE(w.session().history().undo_names().empty());
}

TEST(ImportCommand, AVolumeComesAloneAndANeutralSceneWithAllItHas) {
  TemporaryFolder folder;
  BrickVolumeBuilder builder;
  const std::vector<float> voxels(BrickVolumeBuilder::block_voxels, 1.0f);
  builder.add({0, 0, 0}, voxels.data());
  write_vdb(folder / "a.vdb", builder.build(dmat4(1.0)));
  folder.write("s.json", R"({"volume": "a.vdb", "lights": [{"toward": [0, 1, 0], "intensity": 2}]})");
  TestWorkspace w;
  std::vector<std::string> notes;
  w.session().on_note = [&](const std::string& line) { notes.push_back(line); };
  EXPECT_EQ(w.run("import " + folder / "a.vdb"), "medium_place\nmedium\nmedium_file\nmedium_shape");
  EXPECT_EQ(notes.size(), 3u) << "orientation, density scale, how large it is and where";
  EXPECT_EQ(w.run("ls -type camera"), "");
  EXPECT_EQ(w.run("ls -type renderSettings"), "settings");
  EXPECT_EQ(w.run("import " + folder / "a.vdb" + " -namespace second\nls second:*"),
            "second:medium_place\nsecond:medium\nsecond:medium_file\nsecond:medium_shape\n"
            "second:medium_place\nsecond:medium\nsecond:medium_file\nsecond:medium_shape");
  w.run("import " + folder / "s.json");
  const SceneSnapshot s = w.snapshot();
  EXPECT_EQ(s.media.size(), 3u);
  EXPECT_EQ(s.lights.size(), 1u);
  EXPECT_EQ(w.run("ls -type renderSettings"), "settings") << "there is one of it";
  EXPECT_EQ(s.media[0].volume, s.media[1].volume) << "the same file is one volume";
  EXPECT_EQ(w.refusal("import ahs"), "ahs: there is no such file (did you mean 'ash'?)");
  // One step of undo each.
  w.run("undo 3");
  EXPECT_EQ(w.run("ls"), "time1");
}

TEST(ImportCommand, CallsAMediumAsItIsToldAndSaysHowLargeItIsAndWhere) {
  TestWorkspace w;
  std::vector<std::string> notes;
  w.session().on_note = [&](const std::string& line) { notes.push_back(line); };
  EXPECT_EQ(w.run("import sphere -name smoke"), "smoke_place\nsmoke\nsmoke_shape");
  EXPECT_EQ(notes.back(), "sphere: 2 x 2 x 2 m at (0, 0, 0)");
  EXPECT_EQ(w.run("import box -name smoke"), "smoke1_place\nsmoke1\nsmoke1_shape")
      << "what belongs together has one number";
  w.run("createNode transform -name fire_place");
  EXPECT_EQ(w.run("import box -name fire").substr(0, 5), "fire1");
  EXPECT_EQ(w.run("import box").substr(0, 12), "medium_place");
  EXPECT_EQ(w.run("import box -name camera").substr(0, 7), "camera1") << "a camera may still come";
  EXPECT_NE(w.refusal("import box -name 3d").find("-name: '3d' cannot name a node"), std::string::npos)
      << w.refusal("import box -name 3d");
}

TEST(ImportCommand, MediaAreCalledAfterTheirFiles) {
  EXPECT_EQ(medium_name_of("shots/smoke.vdb"), "smoke");
  EXPECT_EQ(medium_name_of("shots/smoke.####.vdb"), "smoke");
  EXPECT_EQ(medium_name_of("old take/fire-ball v2.vdb"), "fire_ball_v2");
  EXPECT_EQ(medium_name_of("3d.vdb"), "_3d");
  EXPECT_EQ(medium_name_of("####.vdb"), "medium");
}

TEST(ImportCommand, WhatASceneHasOneOfStaysOutOfNamespaces) {
  TemporaryFolder folder;
  for (const char* first : {"import sphere -namespace seq", "import sphere -setup -namespace seq"}) {
    TestWorkspace w;
    w.run(first);
    EXPECT_EQ(w.run("ls -type renderSettings"), "settings") << first;
    w.run("save \"" + folder / "a.plinian" + "\"");
    // By way of a scene that brings them to one that has none.
    w.run("newScene\nimport -namespace far \"" + folder / "a.plinian" + "\"");
    EXPECT_EQ(w.run("ls -type renderSettings"), "settings") << first;
    EXPECT_EQ(w.run("ls far:seq:medium"), "far:seq:medium");
  }
}

TEST(ImportCommand, AdviceNamesItsFlags) {
  TemporaryFolder folder;
  BrickVolumeBuilder builder;
  const std::vector<float> voxels(BrickVolumeBuilder::block_voxels, 1.0f);
  builder.add({0, 0, 0}, voxels.data());
  write_vdb(folder / "a.vdb", builder.build(dmat4(1.0)));
  TestWorkspace w;
  std::string notes;
  w.session().on_note = [&](const std::string& line) { notes += line + "\n"; };
  w.run("import " + folder / "a.vdb");
  EXPECT_NE(notes.find("-upAxis"), std::string::npos) << notes;
  EXPECT_NE(notes.find("-densityScale"), std::string::npos) << notes;
  EXPECT_EQ(notes.find("--"), std::string::npos) << notes;
  EXPECT_EQ(w.refusal("import " + folder / "a.vdb" + " -up-axis z"),
            "import: unknown flag '-up-axis' (did you mean '-upAxis'?)");
}

TEST(ImportCommand, TakesTheOptionsOfAVolumeThatRenderTakes) {
  TemporaryFolder folder;
  BrickVolumeBuilder builder;
  const std::vector<float> voxels(BrickVolumeBuilder::block_voxels, 1.0f);
  builder.add({0, 0, 0}, voxels.data());
  write_vdb(folder / "a.vdb", builder.build(dmat4(1.0)));
  TestWorkspace w;
  w.run("import " + folder / "a.vdb" + " -grid density -upAxis z -densityScale 3 -levelSet fog");
  EXPECT_EQ(w.run("getAttr medium_file.grid\ngetAttr medium_file.up_axis\ngetAttr medium.density_scale\n"
                  "getAttr medium_file.level_set"),
            "\"density\"\nz\n3\nfog");
  EXPECT_EQ(w.run("import ash -resolution 16 -seed 7 -namespace n\ngetAttr n:medium_noise.seed").substr(0, 8),
            "n:medium");
  EXPECT_NE(w.refusal("import " + folder / "a.vdb" + " -grid heat").find("there is no grid \"heat\""),
            std::string::npos)
      << w.refusal("import " + folder / "a.vdb" + " -grid heat");
  EXPECT_NE(w.refusal("import " + folder / "a.vdb" + " -upAxis up").find("import: -upAxis"),
            std::string::npos);
  w.run("import " + folder / "a.vdb" + " -namespace limited -vdbTimeLimit 30 -vdbMemoryLimit 1G");
  EXPECT_EQ(w.run("getAttr limited:medium_file.time_limit\ngetAttr limited:medium_file.memory_limit"),
            "30\n1073741824");
  EXPECT_EQ(w.refusal("import " + folder / "a.vdb" + " -vdbMemoryLimit much"),
            "import: -vdbMemoryLimit much: expected a number of bytes, such as 512M or 4G");
  EXPECT_EQ(w.refusal("import " + folder / "a.vdb" + " -vdbTimeLimit 0"),
            "import: -vdbTimeLimit expects a number of seconds above 0");
  EXPECT_NE(w.refusal("import ash -grid density").find("only a .vdb file has one"), std::string::npos);
  EXPECT_NE(w.refusal("import ash -grd density").find("did you mean '-grid'?"), std::string::npos);
}

}  // namespace
}  // namespace plinian::scene
