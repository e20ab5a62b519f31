// Refinement at rest: to the maps' own limit, without a pop on the way.
#include "tests/viewport/scenes.h"
#include "viewport/gl_renderer.h"

namespace plinian::test {
namespace {

double mean_radiance(const Frame& frame) {
  double sum = 0.0;
  for (const vec3& v : frame.beauty) sum += v.x + v.y + v.z;
  return sum / (3.0 * double(frame.beauty.size()));
}

/// The limit: so many samples through the same maps that more change nothing.
Frame limit_of(SceneSnapshot scene) {
  scene.quality.view.shade_samples = 1024;
  scene.quality.view.step = 0.0625f;
  scene.quality.view.transmittance_cutoff = 1e-4f;
  return make_gl_renderer()->render(scene, 1);
}

// Known gap: ash rests at 54.5 dB of the limit, and its mean falls by 3% on the way from the first pass.
void expect_convergence(const SceneSnapshot& scene) {
  const Frame limit = limit_of(scene);
  const auto renderer = make_gl_renderer();
  const Frame first = renderer->render(scene, 1);
  const Frame rest = renderer->render(scene, scene.quality.view.passes);
  EXPECT_GE(compare(rest, limit).psnr, 55.0);
  EXPECT_GT(compare(rest, limit).psnr, compare(first, limit).psnr);
  double previous = mean_radiance(first);
  for (const int passes : {2, 4, 8, 16, scene.quality.view.passes}) {
    const double mean = mean_radiance(renderer->render(scene, passes));
    EXPECT_NEAR(mean, previous, 0.005 * previous) << passes << " passes";
    previous = mean;
  }
}

TEST(Convergence, AshRestsAtTheLimitOfItsMaps) {
  expect_convergence(ash_scene(128, 128));
}

TEST(Convergence, SmokeRestsAtTheLimitOfItsMaps) {
  SKIP_WITHOUT_SHARED_FILES();
  expect_convergence(shared_scene("smoke-dense.json", 128));
  expect_convergence(shared_scene("smoke-thin.json", 128));
}

}  // namespace
}  // namespace plinian::test
