// The picture of how far maps are from the exact transmittance of light.
#include "core/integrate/map_renderer.h"
#include "tests/viewport/scenes.h"
#include "viewport/gl_renderer.h"

namespace plinian::test {
namespace {

constexpr int size = 96;

SceneSnapshot error_scene(SceneSnapshot scene, const std::string& quality) {
  scene.quality = shipped_preset(quality);
  scene.quality.view.light = LightLookup::error;
  return scene;
}

// Of all lights over all pixels. [-]
double mean_error(const Frame& frame) {
  double sum = 0.0, opacity = 0.0;
  for (std::size_t i = 0; i < frame.beauty.size(); ++i) {
    for (const LightLayer& light : frame.lights)
      sum += double(light.radiance[i].x) / double(frame.lights.size());
    opacity += 1.0 - double(frame.transmittance[i].x);
  }
  return sum / opacity;
}

TEST(MapError, BothRenderersSeeTheSame) {
  for (const SceneSnapshot& scene :
       {error_scene(ash_scene(64, 48), "fast"), error_scene(analytic_scene(48), "fast")}) {
    const Frame gl = make_gl_renderer()->render(scene, 1);
    const Frame cpu = make_map_renderer()->render(scene, 1);
    EXPECT_GT(compare(gl, cpu).psnr, 45.0);
    EXPECT_NEAR(mean_error(gl), mean_error(cpu), 0.02 * mean_error(cpu));
    EXPECT_GT(mean_error(cpu), 1e-4);
  }
}

// What maps get wrong of a picture is at most what they get wrong of the light on its way there, and all of
// it where that has one sign along the ray.
TEST(MapError, BoundsWhatThePictureHasWrong) {
  SceneSnapshot scene = ash_scene(64, size);
  scene.media[0].sigma_s = vec3(0.5f);
  scene.media[0].sigma_a = vec3(0.5f);
  scene.media[0].phase = {};
  scene.lights.resize(1);
  scene.ambient = vec3(0.0f);
  scene.quality = shipped_preset("fast");
  scene.quality.view.exact_light_at_rest = false;
  // As the picture of the error is marched, so that both are shaded at the same places.
  scene.quality.view.march_step = 0.5f;
  scene.quality.view.march_depth = 16.0f;
  scene.quality.view.shade_samples = 2;
  const auto renderer = make_gl_renderer();
  const Frame with_maps = renderer->render(scene, 1);
  SceneSnapshot other = scene;
  other.quality.view.light = LightLookup::march;
  const Frame marched = renderer->render(other, 1);
  // The error is shaded four times as coarsely.
  other.quality.view.shade_samples = 8;
  other.quality.view.light = LightLookup::error;
  const Frame error = renderer->render(other, 1);
  const float albedo = 0.5f, isotropic = 1.0f / (4.0f * 3.14159265f);
  const float arriving = albedo * isotropic * scene.lights[0].power().x;
  double differences = 0.0, errors = 0.0;
  for (std::size_t i = 0; i < error.beauty.size(); ++i) {
    const float difference =
        std::abs(with_maps.lights[0].radiance[i].x - marched.lights[0].radiance[i].x) / arriving;
    const float bound = error.lights[0].radiance[i].x;
    ASSERT_LE(difference, bound + 2e-4f) << i;
    ASSERT_LE(bound, 1.0f);
    differences += difference;
    errors += bound;
  }
  EXPECT_GT(differences, 0.5 * errors) << "of one sign along most rays";
  EXPECT_GT(errors / double(size * size), 1e-4) << "there is something to be seen";
}

TEST(MapError, IsLessWithMoreCoefficientsAndAdaptiveBounds) {
  SceneSnapshot scene = error_scene(ash_scene(128, size), "fast");
  const auto renderer = make_gl_renderer();
  const double fast = mean_error(renderer->render(scene, 1));
  scene.quality.map.encoding = Encoding::tfm;
  scene.quality.map.density_weighting = 1.0f;
  const double original = mean_error(renderer->render(scene, 1));
  const double high = mean_error(renderer->render(error_scene(scene, "high"), 1));
  EXPECT_LT(fast, 0.6 * original);
  EXPECT_LT(high, fast);
  std::printf("mean |T exact - T map| of ash: tfm-6 %.4f, fast %.4f, high %.4f\n", original, fast, high);
}

}  // namespace
}  // namespace plinian::test
