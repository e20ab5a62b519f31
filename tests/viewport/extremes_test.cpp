// Scenes at the edge: they just work, and no NaN ever reaches a picture. On the GPU and on the CPU.
#include "core/integrate/map_renderer.h"
#include "tests/viewport/scenes.h"
#include "viewport/gl_renderer.h"

namespace plinian::test {
namespace {

class Extremes : public testing::TestWithParam<bool> {
 protected:
  Frame render(const SceneSnapshot& scene, int passes = 2) {
    const auto renderer = GetParam() ? make_gl_renderer() : make_map_renderer();
    Frame frame = renderer->render(scene, passes);
    EXPECT_TRUE(all_finite(frame));
    for (const vec3& t : frame.transmittance)
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(t, vec3(0.0f))) &&
                  glm::all(glm::lessThanEqual(t, vec3(1.00001f))));
    return frame;
  }
  SceneSnapshot scene = ash_scene(32, 48);
};
INSTANTIATE_TEST_SUITE_P(Renderers, Extremes, testing::Bool(),
                         [](const auto& info) { return info.param ? "gl" : "cpu"; });

TEST_P(Extremes, CameraInsideTheMedium) {
  scene.camera = look_at({0, 5, 0}, {1, 5, 0.3}, {0, 1, 0}, 60);
  EXPECT_LT(render(scene).transmittance[48 * 24 + 24].x, 0.01f);
}

TEST_P(Extremes, LightsInsideTheMedium) {
  for (const LightType type : {LightType::point, LightType::spot}) {
    Light lamp;
    lamp.type = type;
    lamp.position = {0, 5, 0};
    lamp.radius = 0.0f;
    lamp.intensity = 1000.0f;
    scene.lights.push_back(lamp);
  }
  render(scene);
}

TEST_P(Extremes, AxisParallelRaysAndLights) {
  scene.camera = look_at({0, 5, 30}, {0, 5, 0}, {0, 1, 0}, 1e-3);
  scene.lights[0].toward = {0, 1, 0};
  scene.lights[1].toward = {1, 0, 0};
  EXPECT_LT(render(scene).transmittance[48 * 24 + 24].x, 0.01f);
}

TEST_P(Extremes, DensityTimesTenThousandAndOneTenThousandth) {
  const float usual = scene.media[0].density_scale;
  scene.media[0].density_scale = usual * 1e4f;
  render(scene);
  scene.media[0].density_scale = usual * 1e-4f;
  render(scene);
}

TEST_P(Extremes, LightsOfNoIntensityAndNoLightsAtAll) {
  for (Light& light : scene.lights) light.intensity = 0.0f;
  scene.ambient = vec3(0.0f);
  for (const LightLayer& light : render(scene).lights)
    for (const vec3& v : light.radiance) EXPECT_EQ(v, vec3(0.0f));
  scene.lights.clear();
  render(scene);
}

TEST_P(Extremes, MediaThatExtinguishNothingOrOneChannelOnly) {
  scene.media[0].sigma_s = scene.media[0].sigma_a = vec3(0.0f);
  scene.media[0].emission.scale = 1.0f;
  const Frame glowing = render(scene);
  double glow = 0.0;
  for (const vec3& v : glowing.emission) glow += v.x;
  EXPECT_GT(glow, 0.0) << "emission needs no extinction";
  EXPECT_NEAR(glowing.transmittance[48 * 24 + 24].x, 1.0f, 1e-6f);
  scene.media[0].sigma_s = {0.0f, 0.0f, 1.0f};
  EXPECT_NEAR(render(scene).transmittance[48 * 24 + 24].x, 1.0f, 1e-6f);
}

TEST_P(Extremes, AnEmptySceneIsItsBackground) {
  scene.media.clear();
  scene.background = {0.1f, 0.2f, 0.3f};
  const Frame frame = render(scene);
  EXPECT_EQ(frame.beauty[100], scene.background);
  EXPECT_EQ(frame.lights.size(), scene.lights.size());
}

TEST_P(Extremes, TwoVoxelsAMillionApart) {
  BrickVolumeBuilder builder;
  std::vector<float> ones(512, 1.0f);
  builder.add({0, 0, 0}, ones.data());
  builder.add({125000, 0, 0}, ones.data());
  Medium medium;
  medium.volume = std::make_shared<BrickVolume>(builder.build(dmat4(1.0)));
  EXPECT_GT(medium.volume->levels, 0);
  scene.media = {medium};
  scene.camera = look_at({4, 4, 60}, {4, 4, 4}, {0, 1, 0}, 20);
  EXPECT_LT(render(scene).transmittance[48 * 24 + 24].x, 0.01f);
}

}  // namespace
}  // namespace plinian::test
