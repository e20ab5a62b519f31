// The GL renderer and its CPU twin make the same picture.
#include "core/integrate/map_renderer.h"
#include "tests/viewport/scenes.h"
#include "viewport/gl_renderer.h"

namespace plinian::test {
namespace {

void expect_twins(const SceneSnapshot& scene, int passes = 1) {
  const Frame gl = make_gl_renderer()->render(scene, passes);
  const Frame cpu = make_map_renderer()->render(scene, passes);
  EXPECT_GT(compare(gl, cpu).psnr, 55.0);
  EXPECT_LT(largest_difference(gl, cpu), 5e-3);
  for (std::size_t i = 0; i < gl.beauty.size(); i += 7) {
    vec3 sum = gl.ambient[i] + gl.emission[i] + gl.background[i];
    for (const LightLayer& light : gl.lights) sum += light.radiance[i];
    EXPECT_LT(glm::length(sum - gl.beauty[i]), 1e-4f * (1.0f + glm::length(gl.beauty[i])))
        << "layers sum to beauty";
  }
}

TEST(Twins, AgreeOnAsh) {
  expect_twins(ash_scene(128, 192));
}

TEST(Twins, AgreeOnAshInHighWithFurtherPasses) {
  SceneSnapshot scene = ash_scene(64, 96);
  scene.quality = shipped_preset("high");
  expect_twins(scene, 3);
}

TEST(Twins, AgreeOnDenseSmoke) {
  SKIP_WITHOUT_SHARED_FILES();
  expect_twins(shared_scene("smoke-dense.json", 192));
}

TEST(Twins, AgreeOnAFireWithMuchOfItsLightFromEmission) {
  SKIP_WITHOUT_SHARED_FILES();
  SceneSnapshot scene = fire_scene(192);
  const Frame frame = make_gl_renderer()->render(scene, 1);
  double emitted = 0.0, all = 0.0;
  for (std::size_t i = 0; i < frame.beauty.size(); ++i) {
    emitted += frame.emission[i].x + frame.emission[i].y + frame.emission[i].z;
    all += frame.beauty[i].x + frame.beauty[i].y + frame.beauty[i].z;
  }
  EXPECT_GT(emitted, 0.2 * all);
  EXPECT_LT(emitted, 0.8 * all) << "the rest is scattered light";
  expect_twins(scene);
}

TEST(Twins, AgreeOnOverlappingMediaOfTwoColoursUnderTwoKindsOfLight) {
  expect_twins(analytic_scene(128));
}

TEST(Twins, AgreeOnColouredExtinctionAndPhaseFunctions) {
  SceneSnapshot scene = ash_scene(64, 96);
  scene.media[0].sigma_s = {0.3f, 0.5f, 0.6f};
  scene.media[0].sigma_a = {0.1f, 0.3f, 0.6f};
  scene.media[0].phase = {PhaseKind::two_lobe, 0.5f, -0.3f, 0.3f};
  expect_twins(scene);
}

TEST(Twins, AgreeOnNineLightsAmongThemSpots) {
  SceneSnapshot scene = analytic_scene(64);
  for (int i = 0; i < 7; ++i) {
    Light spot;
    spot.name = "spot" + std::to_string(i);
    spot.type = LightType::spot;
    spot.toward = glm::normalize(vec3(float(i) - 3.0f, 2.0f, 1.0f));
    spot.position = 4.0f * spot.toward;
    spot.cone_angle = 30.0f;
    spot.penumbra = 4.0f;
    spot.intensity = 20.0f;
    scene.lights.push_back(spot);
  }
  expect_twins(scene);
}

}  // namespace
}  // namespace plinian::test
