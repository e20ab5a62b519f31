// Light that grazes a dense face reaches the first hundredths of its opacity alone.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "core/integrate/map_renderer.h"
#include "tests/core/integrate/one_pixel.h"

namespace plinian {
namespace {

TEST(Speckle, OfAGrazedFaceIsGoneAfterAFewExactPasses) {
  SceneSnapshot scene;
  scene.media.push_back(analytic_medium(MediumShape::box, vec3(40.0f), vec3(0.0f)));
  scene.camera = look_at(dvec3(0, 0, 30), dvec3(0), dvec3(0, 1, 0), 1.0);
  scene.width = scene.height = 24;
  // The light leaves the plane of the face by a fiftieth.
  const double slope = 0.02;
  scene.lights.push_back(sun(dvec3(1, 0, slope), vec3(1000.0f)));
  scene.quality.view.shade_samples = 12;
  scene.quality.view.exact_light_at_rest = true;
  const Frame frame = make_map_renderer()->render(scene, 8);
  // Of a half-space, seen along its normal, isotropic: irradiance / (4 pi) * mu / (mu + 1).
  const double mu = slope / std::hypot(1.0, slope);
  const double truth = 1000.0 / (4.0 * std::numbers::pi) * mu / (mu + 1.0);
  double mean = 0.0, square = 0.0;
  for (const vec3& radiance : frame.beauty) {
    mean += radiance.y / double(frame.beauty.size());
    square += radiance.y * radiance.y / double(frame.beauty.size());
  }
  const double noise = std::sqrt(std::max(square - mean * mean, 0.0)) / truth;
  std::printf("mean %.3f of the truth, noise %.3f of it\n", mean / truth, noise);
  EXPECT_NEAR(mean, truth, 0.1 * truth);  // the first pass, of one lookup there, still counts a fifteenth
  EXPECT_LT(noise, 0.1);
}

}  // namespace
}  // namespace plinian
