#include "core/transmittance/map_key.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace plinian {
namespace {

SceneSnapshot scene() {
  SceneSnapshot s;
  Medium medium;
  medium.shape = MediumShape::sphere;
  medium.sigma_s = vec3(0.7f);
  medium.sigma_a = vec3(0.3f);
  s.media.push_back(medium);
  Light light;
  light.toward = glm::normalize(vec3(1, 2, 3));
  s.lights.push_back(light);
  return s;
}

std::string reason(const SceneSnapshot& wanted) {
  return rebuild_reason(map_key(flatten(scene()), 0), map_key(flatten(wanted), 0));
}

TEST(MapKey, AlbedoPhaseLightColourEmissionAndViewBuildNothing) {
  SceneSnapshot s = scene();
  EXPECT_EQ(reason(s), "");
  s.media[0].sigma_s = vec3(0.1f);
  s.media[0].sigma_a = vec3(0.9f);
  s.media[0].phase = {PhaseKind::two_lobe, 0.6f, -0.2f, 0.4f};
  s.media[0].emission.scale = 3.0f;
  s.lights[0].colour = {1, 0.2f, 0.1f};
  s.lights[0].exposure = 2.0f;
  s.camera.focal_length = 80.0f;
  s.quality.view.shade_samples = 40;
  s.ambient = s.background = vec3(1.0f);
  EXPECT_EQ(reason(s), "");
}

TEST(MapKey, NamesEachReasonForBuildingAgain) {
  SceneSnapshot s = scene();
  s.media[0].density_scale = 1.01f;
  EXPECT_EQ(reason(s), "extinction");
  s = scene();
  s.media[0].world_from_medium = glm::translate(dmat4(1.0), dvec3(0.5, 0, 0));
  EXPECT_EQ(reason(s), "transform");
  s = scene();
  s.media[0].shape = MediumShape::box;
  EXPECT_EQ(reason(s), "density field");
  s = scene();
  s.lights[0].toward = glm::normalize(vec3(1, 2, 3.1f));
  EXPECT_EQ(reason(s), "light frame");
  s = scene();
  s.quality.map.threshold = 0.05f;
  EXPECT_EQ(reason(s), "encoding");
  s = scene();
  s.quality.map.resolution = 128;
  EXPECT_EQ(reason(s), "map resolution");
  s = scene();
  s.media.push_back(s.media[0]);
  EXPECT_EQ(reason(s), "number of media");
}

TEST(MapKey, MediaOfProportionalColoursShareAMapAndOthersDoNot) {
  SceneSnapshot s = scene();
  s.media.push_back(s.media[0]);
  s.media[1].sigma_s *= 3.0f;
  s.media[1].sigma_a *= 3.0f;
  EXPECT_EQ(flatten(s).group_count, 1);
  s.media[1].sigma_s.x *= 2.0f;
  EXPECT_EQ(flatten(s).group_count, 2);
  EXPECT_EQ(flatten(s).maps.size(), 2u);
}

// T^r is the transmittance of r times the extinction, so long as nothing else differs.
TEST(MapKey, AMapServesOtherExtinctionsByAPowerWithinWhatIsAllowed) {
  const auto power = [](const SceneSnapshot& built, const SceneSnapshot& wanted, float reuse) {
    return map_power(map_key(flatten(built), 0), map_key(flatten(wanted), 0), reuse);
  };
  SceneSnapshot s = scene();
  EXPECT_EQ(power(scene(), s, 1.0f), 1.0f);
  s.media[0].density_scale *= 1.5f;
  EXPECT_FALSE(power(scene(), s, 1.0f));
  EXPECT_FALSE(power(scene(), s, 1.4f));
  ASSERT_TRUE(power(scene(), s, 2.0f));
  EXPECT_NEAR(*power(scene(), s, 2.0f), 1.5f, 1e-5f);
  ASSERT_TRUE(power(s, scene(), 2.0f));
  EXPECT_NEAR(*power(s, scene(), 2.0f), 1.0f / 1.5f, 1e-5f);
  s.lights[0].toward = glm::normalize(vec3(1, 2, 3.1f));
  EXPECT_FALSE(power(scene(), s, 2.0f)) << "the light went elsewhere, too";

  SceneSnapshot two = scene();
  two.media.push_back(two.media[0]);
  SceneSnapshot denser = two;
  denser.media[0].density_scale *= 1.5f;
  EXPECT_FALSE(power(two, denser, 2.0f)) << "one of two media alone";
  denser.media[1].density_scale *= 1.5f;
  EXPECT_TRUE(power(two, denser, 2.0f));
}

}  // namespace
}  // namespace plinian
