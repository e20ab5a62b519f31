// Refinement at rest: to the maps' own limit, without a pop on the way.
#include "core/integrate/map_renderer.h"
#include "tests/viewport/scenes.h"
#include "viewport/gl_renderer.h"

namespace plinian::test {
namespace {

double mean_radiance(const Frame& frame) {
  double sum = 0.0;
  for (const vec3& v : frame.beauty) sum += v.x + v.y + v.z;
  return sum / (3.0 * double(frame.beauty.size()));
}

/// The limit: so many samples through the same maps that more change nothing. On the CPU: llvmpipe ends loops
/// early, without a word, where there are that many.
Frame limit_of(SceneSnapshot scene) {
  scene.quality.view.shade_samples = 512;
  scene.quality.view.step = 0.125f;
  scene.quality.view.transmittance_cutoff = 1e-4f;
  return make_map_renderer()->render(scene, 1);
}

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
  expect_convergence(ash_scene(128, 96));
}

TEST(Convergence, SmokeRestsAtTheLimitOfItsMaps) {
  SKIP_WITHOUT_SHARED_FILES();
  expect_convergence(shared_scene("smoke-dense.json", 96));
  expect_convergence(shared_scene("smoke-thin.json", 96));
}

}  // namespace
}  // namespace plinian::test
