#include "core/integrate/ray_probe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "tests/core/integrate/one_pixel.h"

namespace plinian {
namespace {

constexpr double sigma = 12.0;  // [1/world]

// A dense ball of radius 1 seen along -z, lit along -x or from a lamp.
SceneSnapshot ball() {
  SceneSnapshot scene = one_pixel(dvec3(0, 0, 10), dvec3(0));
  scene.media.push_back(analytic_medium(MediumShape::sphere, vec3(float(sigma)), vec3(0.0f)));
  scene.quality.map.coefficients = 14;
  return scene;
}

Light lamp(dvec3 position) {
  Light light;
  light.name = "lamp";
  light.type = LightType::point;
  light.position = vec3(position);
  return light;
}

TEST(RayProbe, TellsWhatAViewRayMeets) {
  const ViewRayProbe probe = RayProbe(ball()).view_ray({0, 0}, 101);
  ASSERT_EQ(probe.samples.size(), 101u);
  EXPECT_NEAR(probe.samples.front().t, 9.0, 1e-6);
  EXPECT_NEAR(probe.samples.back().t, 11.0, 1e-6);
  for (const ViewRayProbe::Sample& sample : probe.samples)
    EXPECT_NEAR(sample.transmittance.y, std::exp(-sigma * (sample.t - 9.0)), 1e-6);
  EXPECT_NEAR(probe.samples[50].sigma_t.x, sigma, 1e-9);
  EXPECT_NEAR(probe.depth, 9.0 + std::log(2.0) / sigma, 1e-6);
}

TEST(RayProbe, OfARayThatMeetsNothingIsEmpty) {
  SceneSnapshot scene = one_pixel(dvec3(0, 0, 10), dvec3(0, 9, 10));
  scene.media = ball().media;
  const ViewRayProbe probe = RayProbe(scene).view_ray({0, 0});
  EXPECT_TRUE(probe.samples.empty());
  EXPECT_EQ(probe.depth, std::numeric_limits<double>::infinity());
}

void expect_light_through_the_ball(const SceneSnapshot& scene, const dvec3& point, double entry, double k) {
  const LightRayProbe probe = RayProbe(scene).light_ray(point, 0);
  EXPECT_NEAR(probe.exact.y, std::exp(-sigma * (k - entry)), 1e-5);
  EXPECT_NEAR(probe.map.y, probe.exact.y, 0.02);
  ASSERT_EQ(probe.bounds.size(), 1u);
  EXPECT_TRUE(probe.bounds[0].dense);
  EXPECT_FALSE(probe.bounds[0].missed);
  const double offset = probe.k - k;  // of a directional light's near plane
  // Where light begins to fade and where it is dead, to a step of a bound.
  EXPECT_NEAR(probe.bounds[0].k_min - offset, entry - std::log(0.97) / sigma, 2e-3);
  EXPECT_NEAR(probe.bounds[0].k_max - offset, entry - std::log(scene.quality.map.threshold) / sigma, 2e-3);
  for (const LightRayProbe::Sample& sample : probe.samples) {
    const double inside = std::max(sample.k - offset - entry, 0.0);
    EXPECT_NEAR(sample.exact.y, std::exp(-sigma * inside), 1e-4);
    EXPECT_NEAR(sample.map.y, sample.exact.y, 0.06) << sample.k;  // 14 terms ring most at k_min
  }
  EXPECT_LT(probe.samples.front().k, probe.bounds[0].k_min);
  EXPECT_GT(probe.samples.back().k, probe.bounds[0].k_max);
}

TEST(RayProbe, ShowsASunsTransmittanceAndItsMaps) {
  SceneSnapshot scene = ball();
  scene.lights.push_back(sun(dvec3(1, 0, 0)));
  // Counted from x = 2, light enters at 1.
  expect_light_through_the_ball(scene, dvec3(0.9, 0, 0), 1.0, 1.1);
}

TEST(RayProbe, ShowsALampsTransmittanceAndItsMaps) {
  SceneSnapshot scene = ball();
  scene.lights.push_back(lamp(dvec3(0, 3, 0)));
  expect_light_through_the_ball(scene, dvec3(0, 0.95, 0), 2.0, 2.05);
}

// The ray begins at the lamp, which has no direction to itself.
TEST(RayProbe, FollowsLightFromALampWithinAMedium) {
  for (const LightType type : {LightType::point, LightType::spot})
    for (const dvec3 point : {dvec3(0.3, -0.2, 0.1), dvec3(0.02, 0.0, 0.0)}) {
      SceneSnapshot scene = ball();
      scene.lights.push_back(lamp(dvec3(0.0)));
      scene.lights[0].type = type;
      scene.lights[0].toward = vec3(-normalize(point));
      const LightRayProbe probe = RayProbe(scene).light_ray(point, 0);
      EXPECT_EQ(probe.samples.front().k, 0.0);
      EXPECT_EQ(probe.samples.front().map, dvec3(1.0));
      EXPECT_NEAR(probe.exact.y, std::exp(-sigma * length(point)), 1e-5);
      EXPECT_NEAR(probe.map.y, probe.exact.y, 0.03);
      for (const LightRayProbe::Sample& sample : probe.samples)
        EXPECT_TRUE(sample.map.y >= 0.0 && sample.map.y <= 1.0) << sample.k;
    }
}

TEST(RayProbe, LooksAtTheLampItself) {
  SceneSnapshot scene = ball();
  for (const LightType type : {LightType::point, LightType::spot}) {
    scene.lights = {lamp(dvec3(0.0))};
    scene.lights[0].type = type;
    const LightRayProbe probe = RayProbe(scene).light_ray(dvec3(0.0), 0);
    EXPECT_EQ(probe.exact, dvec3(1.0));
    EXPECT_EQ(probe.map, dvec3(1.0));
  }
}

TEST(RayProbe, FollowsColouredMediaOfTwoGroupsUnderTwoLights) {
  SceneSnapshot scene = ball();
  scene.media[0].sigma_s = vec3(6.0f, 9.0f, 18.0f);
  scene.media[0].density_scale = 0.3f;
  scene.lights.push_back(sun(dvec3(1, 0.3, 0.2)));
  scene.lights.push_back(lamp(dvec3(0, -1.4, 0.5)));
  // A second colour group, which shadows the first.
  Medium veil = analytic_medium(MediumShape::box, vec3(0.5f, 0.1f, 0.1f), vec3(0.0f),
                                glm::translate(dmat4(1.0), dvec3(1.5, 0, 0)));
  scene.media.push_back(veil);
  const RayProbe probe(scene);
  for (std::size_t l = 0; l < 2; ++l) {
    const LightRayProbe at = probe.light_ray(dvec3(0.2, 0.1, 0.7), l);
    EXPECT_EQ(at.bounds.size(), 2u);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(at.map[c], at.exact[c], 0.03) << l;
    EXPECT_GT(at.exact.x, at.exact.z);
  }
}

TEST(RayProbe, RefusesALightThatIsNotThere) {
  EXPECT_THROW(RayProbe(ball()).light_ray(dvec3(0), 0), std::out_of_range);
}

}  // namespace
}  // namespace plinian
