#include "core/scene/scene_file.h"

#include <gtest/gtest.h>

#include "tests/core/scene/temporary_folder.h"

namespace plinian {
namespace {

const std::string neutral = R"({ "volume": "../../data/smoke.vdb", "grid": "density",
  "density_scale": 4.0,            "_": "sigma_t = density * density_scale, per world unit",
  "albedo": [0.8, 0.7, 0.6], "g": 0.0,
  "camera": { "eye": [52.0, 62.0, 172.0], "target": [-7.3, 40.5, 0.5], "up": [0, 1, 0], "fov_y_degrees": 36 },
  "lights": [ { "type": "directional", "toward": [0.8, 0.45, 0.25], "irradiance": [12.566, 12, 11] } ],
  "size": [256, 128] })";

SceneDescription scene_of(const std::string& text) {
  TemporaryFolder folder;
  return read_scene_file(folder.write("scene.json", text));
}

std::string error_for(const std::string& text) {
  TemporaryFolder folder;
  const std::string path = folder.write("scene.json", text);
  std::string error = error_of([&] { read_scene_file(path); });
  EXPECT_EQ(error.find('\n'), std::string::npos);
  if (error.starts_with(folder.path().string())) error = error.substr(folder.path().string().size() + 1);
  return error;
}

TEST(SceneFile, ReadsANeutralSceneInTheFilesOwnSpace) {
  const SceneDescription scene = scene_of(neutral);
  ASSERT_EQ(scene.media.size(), 1u);
  EXPECT_EQ(scene.media[0].volume, "../../data/smoke.vdb");
  EXPECT_EQ(scene.media[0].grid, "density");
  EXPECT_EQ(scene.media[0].density_scale, 4.0f);
  EXPECT_EQ(scene.media[0].albedo, vec3(0.8f, 0.7f, 0.6f));
  EXPECT_FALSE(scene.media[0].guess_orientation);
  EXPECT_EQ(scene.camera.eye, dvec3(52, 62, 172));
  EXPECT_EQ(scene.camera.fov_y_degrees, 36.0f);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].role, LightRole::placed);
  EXPECT_EQ(scene.lights[0].irradiance, vec3(12.566f, 12.0f, 11.0f));
  EXPECT_FALSE(scene.default_lights);
  EXPECT_EQ(scene.size, ivec2(256, 128));
}

TEST(SceneFile, ReadsSeveralMediaAndEveryKindOfLight) {
  const SceneDescription scene = scene_of(R"({
    "media": [
      {"name": "plume", "volume": "ash", "resolution": 64, "seed": 7, "phase": "two_lobe", "g": 0.6,
       "g_back": -0.2, "blend": 0.3, "translate": [0, 1, 0], "rotate": [0, 90, 0], "scale": 2},
      {"volume": "sphere", "sigma_s": [1, 2, 3], "sigma_a": 0.5, "emission_scale": 2}],
    "lights": [
      {"name": "lamp", "type": "spot", "position": [1, 2, 3], "target": [0, 0, 0], "cone_angle": 30,
       "penumbra": 4, "kelvin": 3200, "intensity": 5, "exposure": 1, "falloff": "linear", "radius": 0.2},
      {"type": "point", "position": [4, 5, 6]}],
    "camera": {"translate": [0, 0, 9], "rotate": [-10, 20, 0], "focal_length": 50, "film_back": [36, 24],
               "film_fit": "overscan", "film_offset": [1, 2], "pixel_aspect": 2},
    "ambient": [0.1, 0.2, 0.3], "background": 0.5})");
  ASSERT_EQ(scene.media.size(), 2u);
  EXPECT_EQ(scene.media[0].name, "plume");
  EXPECT_EQ(scene.media[0].phase, PhaseKind::two_lobe);
  EXPECT_EQ(scene.media[0].scale, dvec3(2));
  EXPECT_EQ(scene.media[1].name, "medium1");
  EXPECT_EQ(scene.media[1].sigma_a, vec3(0.5f));
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].type, LightType::spot);
  EXPECT_EQ(scene.lights[0].falloff, Falloff::linear);
  EXPECT_EQ(scene.lights[1].name, "light1");
  EXPECT_EQ(scene.camera.film_fit, FilmFit::overscan);
  EXPECT_EQ(scene.background, vec3(0.5f));
}

TEST(SceneFile, WithoutLightsHasTheDefaultOnesAndWithAnEmptyListNone) {
  EXPECT_EQ(scene_of(R"({"volume": "ash"})").lights.size(), 2u);
  EXPECT_TRUE(scene_of(R"({"volume": "ash"})").default_lights);
  EXPECT_TRUE(scene_of(R"({"volume": "ash", "lights": []})").lights.empty());
}

TEST(SceneFile, SaysInOneLineWhereWhatAndWhy) {
  const auto with_light = [](const std::string& light) {
    return error_for(R"({"volume": "ash", "lights": [)" + light + "]}");
  };
  EXPECT_EQ(with_light(R"({"irradiance": [1, -2, 3]})"),
            "scene.json: lights[0].irradiance: expected a number or 3 numbers >= 0, got [1,-2,3]");
  EXPECT_EQ(with_light(R"({"toward": [1, 2]})"),
            "scene.json: lights[0].toward: expected 3 numbers, got [1,2]");
  EXPECT_EQ(with_light(R"({"towards": [1, 2, 3]})"),
            "scene.json: lights[0].towards: unknown key (did you mean 'toward'?)");
  EXPECT_EQ(with_light(R"({"kelvin": 3000, "colour": [1, 1, 1]})"),
            "scene.json: lights[0].colour: cannot stand beside kelvin; give one of them");
  EXPECT_EQ(with_light(R"({"name": "a"}, {"name": "a"})"), "scene.json: lights[1].name: 'a' is taken");
  EXPECT_EQ(with_light(R"({"name": "ambient"})"),
            "scene.json: lights[0].name: 'ambient' means something else here");
  EXPECT_EQ(with_light(R"({"name": "a.R"})"),
            "scene.json: lights[0].name: expected letters, digits, _ and - , got 'a.R'");
  EXPECT_EQ(with_light("7"), "scene.json: lights[0]: expected an object, got 7");
  EXPECT_EQ(error_for(R"({"volume": "ash", "lights": {}})"), "scene.json: lights: expected a list, got {}");
  EXPECT_EQ(error_for(R"({"volume": "ash", "camrea": {}})"),
            "scene.json: camrea: unknown key (did you mean 'camera'?)");
  EXPECT_EQ(error_for(R"({"volume": "ash", "albedo": 1.5})"),
            "scene.json: albedo: expected a number or 3 numbers from 0 to 1, got 1.5");
  EXPECT_EQ(error_for(R"({"volume": "ash", "g": 1})"), "scene.json: g: expected a number in (-1, 1), got 1");
  EXPECT_EQ(error_for(R"({"volume": 3})"), "scene.json: volume: expected a text, got 3");
  EXPECT_EQ(error_for(R"({"lights": []})"), "scene.json: volume: the key is missing");
  EXPECT_EQ(error_for(R"({"media": [{"grid": "x"}]})"), "scene.json: media[0].volume: the key is missing");
  EXPECT_EQ(error_for(R"({"media": [], "grid": "x"})"),
            "scene.json: media: keys of a medium stand beside it; put them into it");
  EXPECT_EQ(error_for(R"({"volume": "ash", "camera": {"fov_y_degrees": 40, "focal_length": 50}})"),
            "scene.json: camera.focal_length: cannot stand beside fov_y_degrees; give one of them");
  EXPECT_EQ(error_for(R"({"volume": "ash", "camera": {"fov_y_degrees": 180}})"),
            "scene.json: camera.fov_y_degrees: expected a number in (0, 180), got 180");
  EXPECT_EQ(error_for(R"({"volume": "ash", "size": [0, 100]})"),
            "scene.json: size[0]: expected an integer from 1 to 32768, got 0");
  EXPECT_EQ(error_for(R"({"volume": "ash", "size": 100})"),
            "scene.json: size: expected [width, height], got 100");
  EXPECT_EQ(error_for("[]"), "scene.json: expected an object, got []");
  EXPECT_NE(error_for(R"({"volume": "ash", "density_scale": 1e999})").find("not JSON"), std::string::npos);
  EXPECT_NE(error_for(R"({"volume": "ash", "density_scale": 1e300})").find("expected a number"),
            std::string::npos);
}

TEST(SceneEdit, ReachesTheCameraTheMediaTheLightsAndTheScene) {
  SceneDescription scene = describe_input("ash");
  set_scene_value(scene, "medium.albedo", "0.5,0.4,0.3");
  EXPECT_EQ(scene.media[0].albedo, vec3(0.5f, 0.4f, 0.3f));
  set_scene_value(scene, "medium.albedo", "0.5");
  EXPECT_EQ(scene.media[0].albedo, vec3(0.5f));
  set_scene_value(scene, "key.exposure", "1");
  EXPECT_EQ(scene.lights[0].exposure, 1.0f);
  EXPECT_EQ(scene.lights[1].exposure, std::nullopt);
  set_scene_value(scene, "lights.colour", "[1, 0, 0]");
  EXPECT_EQ(scene.lights[1].colour, vec3(1, 0, 0));
  set_scene_value(scene, "camera.focal_length", "50");
  EXPECT_EQ(scene.camera.focal_length, 50.0f);
  set_scene_value(scene, "background", "0.1,0.2,0.3");
  EXPECT_EQ(scene.background, vec3(0.1f, 0.2f, 0.3f));
  set_scene_value(scene, "size", "64,32");
  EXPECT_EQ(scene.size, ivec2(64, 32));
  set_scene_value(scene, "medium.grid", "2");
  EXPECT_EQ(scene.media[0].grid, "2");
}

TEST(SceneEdit, TakesThePlaceOfWhatSaysTheSameInAnotherWay) {
  SceneDescription scene = scene_of(neutral);
  set_scene_value(scene, "camera.focal_length", "50");
  EXPECT_EQ(scene.camera.fov_y_degrees, std::nullopt);
  set_scene_value(scene, "light0.kelvin", "3000");
  EXPECT_EQ(scene.lights[0].irradiance, std::nullopt);
  set_scene_value(scene, "medium.sigma_s", "1");
  EXPECT_EQ(scene.media[0].albedo, std::nullopt);
}

TEST(SceneEdit, NamesTheNearestKeyOrObject) {
  SceneDescription scene = describe_input("ash");
  const auto error = [&](const char* name, const char* value) {
    return error_of([&] { set_scene_value(scene, name, value); });
  };
  EXPECT_TRUE(
      error("medium.albdo", "1").starts_with("--set medium.albdo: unknown key (did you mean 'albedo'?)"));
  EXPECT_EQ(
      error("kye.exposure", "1"),
      "--set kye.exposure: nothing is called 'kye' (did you mean 'key'?); there are: map, view, camera, "
      "medium, lights, key, rim");
  EXPECT_TRUE(error("ambeint", "1").starts_with("--set ambeint: unknown key (did you mean 'ambient'?)"));
  EXPECT_EQ(error("medium.albedo", "2"),
            "--set medium.albedo: expected a number or 3 numbers from 0 to 1, got 2");
  EXPECT_EQ(error("key.name", "x"), "--set key.name: names are given in scene files");
}

}  // namespace
}  // namespace plinian
