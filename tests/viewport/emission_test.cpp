// Emitted light against closed forms, on every renderer.
#include <cmath>

#include "core/integrate/dual_march.h"
#include "core/integrate/map_renderer.h"
#include "core/media/blackbody.h"
#include "tests/viewport/scenes.h"
#include "viewport/gl_renderer.h"

namespace plinian::test {
namespace {

std::unique_ptr<Renderer> renderer_of(const std::string& name) {
  if (name == "gl") return make_gl_renderer();
  if (name == "cpu") return make_map_renderer();
  return std::make_unique<DualMarch>();
}

class Emission : public testing::TestWithParam<const char*> {
 protected:
  // One pixel, along -z through the middle of a medium, by no light but its own.
  vec3 emitted(const Medium& medium) {
    SceneSnapshot scene;
    scene.media = {medium};
    scene.camera = look_at({0, 0, 60}, {0, 0, 0}, {0, 1, 0}, 0.01);
    scene.width = scene.height = 1;
    scene.quality = shipped_preset("high");
    scene.quality.view.transmittance_cutoff = 1e-4f;
    scene.quality.view.step =
        0.25f;  // a fade over one voxel is no thin matter to be sampled every second one
    const Frame frame = renderer_of(GetParam())->render(scene, 1);
    EXPECT_EQ(frame.beauty[0], frame.emission[0]);
    return frame.emission[0];
  }
  void expect_near(vec3 radiance, dvec3 truth) {
    // The reference is held to its own tolerance elsewhere; maps and view march end at the cut-off.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(radiance[c], truth[c], 2e-3 * truth[c] + 1e-6) << "channel " << c;
  }
};
INSTANTIATE_TEST_SUITE_P(Renderers, Emission, testing::Values("gl", "cpu", "reference"),
                         [](const auto& info) { return std::string(info.param); });

/// Radiance of a depth of constant temperature: strength * (T / 1800)^4 * colour * (1 - e^-tau) / sigma.
dvec3 slab(double strength, double kelvin, dvec3 sigma, double depth) {
  dvec3 radiance(planck_colour(kelvin));
  for (int c = 0; c < 3; ++c)
    radiance[c] *= strength * std::pow(kelvin / 1800.0, 4) *
                   (sigma[c] > 0.0 ? -std::expm1(-sigma[c] * depth) / sigma[c] : depth);
  return radiance;
}

TEST_P(Emission, OfAHomogeneousBoxIsThatOfASlab) {
  Medium box;
  box.shape = MediumShape::box;
  for (const float kelvin : {1000.0f, 1800.0f, 4000.0f})
    for (const float density : {0.01f, 0.7f, 40.0f}) {
      box.density_scale = density;
      box.sigma_s = vec3(0.3f);
      box.sigma_a = {0.2f, 0.4f, 1.7f};
      box.emission = {.scale = 0.6f, .exposure = 1.0f, .temperature_offset = kelvin};
      expect_near(emitted(box), slab(1.2 * density, kelvin, double(density) * dvec3(0.5, 0.7, 2.0), 2.0));
    }
}

TEST_P(Emission, OfVoxelsOfOneTemperatureIsThatOfASlab) {
  // 32 voxels of density 1; over one more at each end density fades to nothing, heat does not.
  BrickVolumeBuilder builder;
  std::vector<float> ones(512, 1.0f), heat(512, 1500.0f), few(512, 1e-6f);
  for (int z = -3; z < 3; ++z)
    for (int y = -1; y < 1; ++y)
      for (int x = -1; x < 1; ++x)
        builder.add({x, y, z}, z == -3 || z == 2 ? few.data() : ones.data(), heat.data());
  Medium medium;
  medium.volume = std::make_shared<BrickVolume>(builder.build(dmat4(1.0)));
  medium.sigma_s = vec3(0.1f);
  medium.sigma_a = vec3(0.3f);
  // 300 K + 1.2 * 1500 K = 2100 K.
  medium.emission = {.scale = 2.0f, .temperature_scale = 1.2f, .temperature_offset = 300.0f};
  for (const float density : {0.002f, 0.05f}) {
    medium.density_scale = density;
    expect_near(emitted(medium), slab(2.0 * density, 2100.0, dvec3(0.4 * density), 32.0));
  }
}

TEST(Luminance, OfEmissionIsThatOfItsTemperatureAlone) {
  for (const double kelvin : {700.0, 1800.0, 6500.0}) {
    const vec3 colour = planck_colour(kelvin);
    EXPECT_NEAR(0.2126729 * colour.x + 0.7151522 * colour.y + 0.0721750 * colour.z, 1.0, 1e-5) << kelvin;
  }
}

}  // namespace
}  // namespace plinian::test
