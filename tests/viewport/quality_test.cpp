// How near the presets come to the offline reference, in the preset's own single pass, and what adaptation
// gains. Pictures are smaller than those of the README's table, for time; the limits are the same.
#include "core/integrate/dual_march.h"
#include "tests/viewport/scenes.h"
#include "viewport/gl_renderer.h"

namespace plinian::test {
namespace {

struct Limits {
  double fast_psnr, fast_ssim, high_psnr, high_ssim, gain;
};

void expect_quality(SceneSnapshot scene, Limits limits) {
  DualMarch reference;
  const Frame truth = reference.render(scene);
  const auto renderer = make_gl_renderer();
  const auto measure = [&](const Quality& quality) {
    scene.quality = quality;
    return renderer->render(scene, 1);
  };
  const Frame fast = measure(shipped_preset("fast")), high = measure(shipped_preset("high"));
  EXPECT_GE(compare(fast, truth).psnr, limits.fast_psnr);
  EXPECT_GE(structural_similarity(fast, truth), limits.fast_ssim);
  EXPECT_GE(compare(high, truth).psnr, limits.high_psnr);
  EXPECT_GE(structural_similarity(high, truth), limits.high_ssim);
  // The published full-range map at 6 coefficients, without weighting, against the adaptive one.
  Quality original = shipped_preset("fast");
  original.map.encoding = Encoding::tfm;
  original.map.density_weighting = 1.0f;
  const double gain = compare(fast, truth).psnr - compare(measure(original), truth).psnr;
  EXPECT_GT(gain, limits.gain);
  std::printf("fast %.2f dB %.4f, high %.2f dB %.4f, adaptation gains %.2f dB\n", compare(fast, truth).psnr,
              structural_similarity(fast, truth), compare(high, truth).psnr,
              structural_similarity(high, truth), gain);
}

TEST(Quality, Ash) {
  expect_quality(ash_scene(256, 192), {35.0, 0.975, 40.0, 0.99, 12.0});
}

TEST(Quality, DenseSmoke) {
  SKIP_WITHOUT_SHARED_FILES();
  expect_quality(shared_scene("smoke-dense.json", 192), {35.0, 0.975, 40.0, 0.99, 7.0});
}

TEST(Quality, ThinSmoke) {
  SKIP_WITHOUT_SHARED_FILES();
  expect_quality(shared_scene("smoke-thin.json", 192), {47.0, 0.995, 52.0, 0.997, -0.1});
}

TEST(Quality, FurtherPassesOfHighMarchToTheLightAndApproachTheReference) {
  SceneSnapshot scene = ash_scene(64, 96);
  const Frame truth = DualMarch().render(scene);
  scene.quality = shipped_preset("high");
  const auto renderer = make_gl_renderer();
  const double first = compare(renderer->render(scene, 1), truth).psnr;
  const double rest = compare(renderer->render(scene, 24), truth).psnr;
  EXPECT_GT(rest, first + 6.0);
}

}  // namespace
}  // namespace plinian::test
