// The offline reference as a picture: convergence, layers, invariance, robustness.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>

#include "core/integrate/dual_march.h"
#include "core/shared/phase.h"
#include "tests/core/integrate/closed_forms.h"
#include "tests/core/integrate/one_pixel.h"

namespace plinian {
namespace {

/// A rough cloud of 28^3 voxels about the origin, dense in the middle.
std::shared_ptr<const BrickVolume> rough_cloud() {
  static const auto volume = voxels({-14, -14, -14}, {13, 13, 13}, [](ivec3 v) {
    const std::uint32_t h = (std::uint32_t(v.x) * 73856093u) ^ (std::uint32_t(v.y) * 19349663u) ^
                            (std::uint32_t(v.z) * 83492791u);
    const float noise = float((h * 2654435761u) >> 8) / float(1 << 24);
    return glm::max(0.0f, 0.6f + 0.6f * noise - glm::length(vec3(v) + 0.5f) / 14.0f);
  });
  return volume;
}

SceneSnapshot cloud_scene(float density = 1.0f) {
  SceneSnapshot scene;
  scene.camera = look_at({30, 12, 40}, {0, 0, 0}, {0, 1, 0}, 36.0);
  scene.width = scene.height = 24;
  Medium medium;
  medium.volume = rough_cloud();
  medium.density_scale = density;
  scene.media = {medium};
  scene.lights = {sun({0.8, 0.45, 0.25}, {3.0f, 2.0f, 1.0f})};
  return scene;
}

double largest(const std::vector<vec3>& plane) {
  double result = 0.0;
  for (const vec3& v : plane) result = glm::max(result, double(glm::max(v.x, glm::max(v.y, v.z))));
  return result;
}

TEST(DualMarchConvergence, ErrorsFallByMoreThanTheThirdPowerOfTheStep) {
  // A box lit along an axis: one face is nearest to the light everywhere, so that the light along a ray is
  // smooth. Mean over many rays, since where steps happen to end makes a single ray's error irregular.
  constexpr double sigma_t = 2.0;
  constexpr int levels = 5, rays = 64;
  const dvec3 eye(0.5, 1, 5), toward(0, 1, 0);
  SceneSnapshot scene;
  scene.media = {analytic_medium(MediumShape::box, vec3(1.5f), vec3(0.5f))};
  scene.lights = {sun(toward)};
  MarchSteps steps;
  steps.length = 64.0;  // half of the box
  const ReferenceScene march(scene, steps);
  RayIntegral integral(march);
  double errors[levels] = {}, sum = 0.0;
  for (int i = 0; i < rays; ++i) {
    const dvec3 d = glm::normalize(dvec3(0.1 * (i % 8) - 0.35, 0.1 * (i / 8) - 0.35, 0) - eye);
    const double truth = truth::box_directional(eye, d, dvec3(1.0), toward, sigma_t, 1.5, 1.0,
                                                double(shared::inverse_four_pi));
    sum += truth;
    for (int level = 0; level < levels; ++level)
      errors[level] += std::abs(integral.integrate({eye, d}, 0.0, level).lights[0].x - truth);
  }
  EXPECT_LT(errors[0], 0.01 * sum);
  for (int level = 1; level < levels; ++level)
    EXPECT_LT(errors[level], glm::max(errors[level - 1] / 8.0, 1e-9 * sum)) << "level " << level;
}

TEST(DualMarchConvergence, SettledPicturesDoNotChangeUnderFarFinerSteps) {
  for (const float density : {0.02f, 1.0f, 40.0f}) {
    const SceneSnapshot scene = cloud_scene(density);
    DualMarch usual;
    DualMarchOptions fine;
    fine.steps = {.length = 0.25, .optical_depth = 0.0625, .light_distance = 0.0625, .growth = 0.0};
    fine.max_doublings = 0;
    const Frame found = usual.render(scene), truth = DualMarch(fine).render(scene);
    EXPECT_TRUE(usual.stats().warnings.empty()) << usual.stats().warnings[0];
    const double peak = largest(truth.beauty);
    for (std::size_t i = 0; i < truth.beauty.size(); ++i)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found.beauty[i][c], truth.beauty[i][c], 2e-4 * peak)
            << "pixel " << i << ", density " << density;
  }
}

TEST(DualMarchConvergence, OnlyPixelsThatStillChangeAreRefined) {
  DualMarch march;
  march.render(cloud_scene());
  const std::vector<std::int64_t>& pixels = march.pixels_per_level();
  ASSERT_GE(pixels.size(), 3u);  // two doublings have to agree
  EXPECT_EQ(pixels.front(), 24 * 24);
  EXPECT_LT(pixels[1], pixels[0]);  // rays beside the cloud are exact at once
  EXPECT_LT(pixels.back(), pixels[1]);
  EXPECT_EQ(march.stats().passes, static_cast<int>(pixels.size()));
}

TEST(DualMarchConvergence, SaysWhenPixelsHaveNotSettled) {
  DualMarchOptions hasty;
  hasty.max_doublings = 1;
  DualMarch march(hasty);
  march.render(cloud_scene());
  ASSERT_EQ(march.stats().warnings.size(), 1u);
  EXPECT_NE(march.stats().warnings[0].find("not settled"), std::string::npos);
}

TEST(DualMarchConvergence, ThePictureDoesNotDependOnTheNumberOfThreads) {
  const SceneSnapshot scene = cloud_scene();
  const auto with_threads = [&](std::size_t count) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, count);
    return DualMarch().render(scene);
  };
  const Frame one = with_threads(1), many = with_threads(8);
  EXPECT_EQ(std::memcmp(one.beauty.data(), many.beauty.data(), one.beauty.size() * sizeof(vec3)), 0);
  EXPECT_EQ(std::memcmp(one.depth.data(), many.depth.data(), one.depth.size() * sizeof(float)), 0);
}

TEST(DualMarchConvergence, LayersSumToBeauty) {
  SceneSnapshot scene = cloud_scene();
  scene.media[0].emission = {.scale = 0.01f, .temperature_offset = 2000.0f};
  Medium haze = analytic_medium(MediumShape::sphere, vec3(0.01f, 0.02f, 0.03f), vec3(0.01f),
                                glm::scale(dmat4(1.0), dvec3(18.0)));
  haze.phase = {.kind = PhaseKind::henyey_greenstein, .g = 0.5f};
  scene.media.push_back(haze);
  Light lamp;
  lamp.name = "lamp";
  lamp.type = LightType::point;
  lamp.position = {-10, 14, 12};
  lamp.intensity = 200.0f;
  scene.lights.push_back(lamp);
  scene.ambient = {0.1f, 0.2f, 0.3f};
  scene.background = {0.3f, 0.2f, 0.1f};
  const Frame frame = DualMarch().render(scene);
  ASSERT_EQ(frame.lights.size(), 2u);
  EXPECT_EQ(frame.lights[1].name, "lamp");
  for (const auto* plane : {&frame.lights[0].radiance, &frame.lights[1].radiance, &frame.ambient,
                            &frame.emission, &frame.background})
    EXPECT_GT(largest(*plane), 0.01);
  for (std::size_t i = 0; i < frame.beauty.size(); ++i) {
    const vec3 sum = frame.lights[0].radiance[i] + frame.lights[1].radiance[i] + frame.ambient[i] +
                     frame.emission[i] + frame.background[i];
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(frame.beauty[i][c], sum[c], 1e-6f * (1.0f + sum[c]));
  }
}

TEST(DualMarchConvergence, EmptySpaceIsExactlyTheBackground) {
  SceneSnapshot scene = cloud_scene();
  scene.background = {0.25f, 0.5f, 0.75f};
  const Frame frame = DualMarch().render(scene);
  EXPECT_EQ(frame.beauty[0], scene.background);  // a corner of the picture, beside the cloud
  EXPECT_EQ(frame.transmittance[0], vec3(1.0f));
  EXPECT_TRUE(std::isinf(frame.depth[0]));
}

// Invariance
// --------------------------------------------------------------------------------------------------------

void expect_same(const Frame& a, const Frame& b, bool mirrored) {
  const double peak = largest(a.beauty);
  EXPECT_GT(peak, 0.01);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const vec3 there = b.beauty[std::size_t(y) * a.width + (mirrored ? a.width - 1 - x : x)];
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(a.beauty[std::size_t(y) * a.width + x][c], there[c], 2e-4 * peak) << x << ", " << y;
    }
}

TEST(DualMarchConvergence, TurningTheWholeWorldChangesNothing) {
  const SceneSnapshot still = cloud_scene();
  SceneSnapshot turned = still;
  const dmat4 turn = glm::translate(dmat4(1.0), dvec3(7, -3, 2)) *
                     glm::rotate(dmat4(1.0), 1.1, glm::normalize(dvec3(1, -2, 0.5)));
  turned.camera.world_from_camera = turn * still.camera.world_from_camera;
  turned.media[0].world_from_medium = turn;
  turned.lights[0].toward = vec3(turn * dvec4(still.lights[0].toward, 0.0));
  expect_same(DualMarch().render(still), DualMarch().render(turned), false);
}

TEST(DualMarchConvergence, AMirroredMediumGivesAMirroredPicture) {
  SceneSnapshot scene = cloud_scene();
  scene.camera = look_at({0, 12, 40}, {0, 0, 0}, {0, 1, 0}, 36.0);
  SceneSnapshot mirrored = scene;
  mirrored.media[0].world_from_medium = glm::scale(dmat4(1.0), {-1.0, 1.0, 1.0});
  mirrored.lights[0].toward.x *= -1.0f;
  const Frame here = DualMarch().render(scene), there = DualMarch().render(mirrored);
  expect_same(here, there, true);
  EXPECT_GT(glm::length(here.beauty[24 * 12 + 10] - here.beauty[24 * 12 + 13]),
            1e-3f);  // not symmetric by itself
}

TEST(DualMarchConvergence, AScaledWorldWithThinnerMediaLooksTheSame) {
  const SceneSnapshot scene = cloud_scene();
  SceneSnapshot large = scene;
  large.camera = look_at({3000, 1200, 4000}, {0, 0, 0}, {0, 1, 0}, 36.0);
  large.media[0].world_from_medium = glm::scale(dmat4(1.0), dvec3(100.0));
  large.media[0].density_scale = 0.01f;
  expect_same(DualMarch().render(scene), DualMarch().render(large), false);
}

TEST(DualMarchConvergence, AStretchedMediumIsThinnerAlongTheStretch) {
  // Optical depth along x of a grid stretched by 3: three times that of the grid itself.
  SceneSnapshot scene = one_pixel({90, 0, 0}, {0, 0, 0});
  Medium medium;
  medium.volume = rough_cloud();
  medium.density_scale = 0.05f;
  scene.media = {medium};
  const float plain = DualMarch().render(scene).transmittance[0].x;
  scene.media[0].world_from_medium = glm::scale(dmat4(1.0), {3.0, 0.5, 1.0});
  EXPECT_NEAR(DualMarch().render(scene).transmittance[0].x, std::pow(plain, 3.0f), 1e-5f);
}

// Robustness
// --------------------------------------------------------------------------------------------------------

void expect_finite(const Frame& frame, double bound) {
  for (std::size_t i = 0; i < frame.beauty.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      ASSERT_TRUE(std::isfinite(frame.beauty[i][c])) << "pixel " << i;
      ASSERT_GE(frame.beauty[i][c], 0.0f) << "pixel " << i;
      ASSERT_LE(frame.beauty[i][c], bound) << "pixel " << i;
      ASSERT_GE(frame.transmittance[i][c], 0.0f);
      ASSERT_LE(frame.transmittance[i][c], 1.0f);
      ASSERT_FALSE(std::isnan(frame.depth[i]));
    }
}

TEST(DualMarchRobustness, ExtremeDensitiesAreOpaqueAndNoBrighterThanTheirSurface) {
  for (const float density : {1e4f, 1e8f, 1e-8f, 0.0f}) {
    const SceneSnapshot scene = cloud_scene(density);
    const Frame frame = DualMarch().render(scene);
    expect_finite(frame, 3.0 * 0.8 / (4 * std::numbers::pi) * 1.0001);
    if (density > 1.0f) {
      EXPECT_LT(frame.transmittance[24 * 12 + 12].x, 1e-20f);
      EXPECT_GT(largest(frame.beauty), 0.02);
    }
    if (density == 0.0f) {
      EXPECT_EQ(largest(frame.beauty), 0.0);
    }
  }
}

TEST(DualMarchRobustness, ChannelsMayHaveNoExtinctionAtAll) {
  SceneSnapshot scene = cloud_scene(1e4f);
  scene.media[0].sigma_s = {0.5f, 0.0f, 0.0f};
  scene.media[0].sigma_a = {0.5f, 0.0f, 1.0f};
  const Frame frame = DualMarch().render(scene);
  expect_finite(frame, 1.0);
  EXPECT_EQ(frame.transmittance[24 * 12 + 12].y, 1.0f);
  EXPECT_EQ(frame.beauty[24 * 12 + 12].z, 0.0f);
  EXPECT_GT(frame.beauty[24 * 12 + 12].x, 1e-3f);
}

TEST(DualMarchRobustness, CameraAndLightsMayBeInsideTheMedium) {
  SceneSnapshot scene = cloud_scene();
  scene.camera = look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 60.0);  // on the corner of a cell
  scene.width = scene.height = 7;                                  // the middle ray is parallel to an axis
  Light lamp;
  lamp.type = LightType::point;
  lamp.position = {0, 0, -4};  // on that ray, without a radius
  scene.lights.push_back(lamp);
  lamp.type = LightType::spot;
  lamp.position = {0, 0, 0};  // in the camera
  lamp.toward = {0, 0, 1};
  scene.lights.push_back(lamp);
  expect_finite(DualMarch().render(scene), 1e30);
}

TEST(DualMarchRobustness, DarkLightsKeepTheirLayerAndChangeNothing) {
  SceneSnapshot scene = cloud_scene();
  const Frame alone = DualMarch().render(scene);
  Light off = scene.lights[0];
  off.name = "off";
  off.intensity = 0.0f;
  scene.lights.insert(scene.lights.begin(), off);
  const Frame frame = DualMarch().render(scene);
  ASSERT_EQ(frame.lights.size(), 2u);
  EXPECT_EQ(frame.lights[0].name, "off");
  EXPECT_EQ(largest(frame.lights[0].radiance), 0.0);
  EXPECT_EQ(frame.beauty, alone.beauty);
}

TEST(DualMarchRobustness, AWorldWithoutMediaIsItsBackground) {
  SceneSnapshot scene = cloud_scene();
  scene.media.clear();
  scene.background = vec3(0.5f);
  EXPECT_EQ(DualMarch().render(scene).beauty[100], vec3(0.5f));
  scene.lights[0].toward = vec3(0.0f);
  EXPECT_THROW(DualMarch().render(scene), std::invalid_argument);
  scene.lights[0].type = LightType::point;  // shines everywhere and needs no direction
  EXPECT_EQ(DualMarch().render(scene).beauty[100], vec3(0.5f));
  scene.width = 0;
  EXPECT_THROW(DualMarch().render(scene), std::invalid_argument);
}

TEST(DualMarchRobustness, ProgressGrowsToOneAndMayCancel) {
  const SceneSnapshot scene = cloud_scene();
  std::vector<double> reports;
  DualMarch().render(scene, 0, [&](double done) {
    reports.push_back(done);
    return true;
  });
  ASSERT_GT(reports.size(), 3u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_EQ(reports.back(), 1.0);
  int calls = 0;
  EXPECT_THROW(DualMarch().render(scene, 0, [&](double) { return ++calls < 3; }), RenderCancelled);
  EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace plinian
