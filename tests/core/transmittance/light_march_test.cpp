// Maps of media whose transmittance is known in closed form.
#include "core/shared/light_march.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/integrate/flat_scene.h"
#include "core/shared/map_decode.h"

namespace plinian {
namespace {

/// A slab of density 1 in [-1, 1]^3 under a light along -z, and its one map encoded on the CPU.
struct Slab {
  SceneSnapshot snapshot;
  FlatScene flat;
  std::vector<uvec4> texels;

  explicit Slab(float sigma_t, const MapQuality& quality, MediumShape shape = MediumShape::box) {
    Medium medium;
    medium.shape = shape;
    medium.sigma_s = vec3(0.5f * sigma_t);
    medium.sigma_a = vec3(0.5f * sigma_t);
    snapshot.media.push_back(medium);
    Light light;
    light.toward = {0, 0, 1};
    snapshot.lights.push_back(light);
    snapshot.quality.map = quality;
    snapshot.quality.map.resolution = 32;
    encode();
  }
  void encode() {
    flat = flatten(snapshot);
    const int size = flat.layout.resolution, words = words_per_texel(flat.layout.coefficients);
    texels.resize(std::size_t(size) * size * words);
    const MarchViews views = view_of(flat, nullptr);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const vec2 uv = (vec2(x, y) + 0.5f) / float(size);
        float c[16];
        const uint bounds = shared::encode_texel(views.scene, shared::map_ray_origin(views.scene, 0, uv),
                                                 shared::map_ray_direction(views.scene, 0, uv), 0,
                                                 flat.maps[0].k_max, flat.encode, c);
        const auto pair = [&](int j) { return glm::packHalf2x16(vec2(c[j], c[j + 1])); };
        uvec4* texel = &texels[(std::size_t(y) * size + x) * words];
        texel[0] = {pair(0), pair(2), pair(4), bounds};
        if (words > 1) texel[1] = {pair(6), pair(8), pair(10), pair(12)};
        if (words > 2) texel[2] = {pair(14), 0u, 0u, 0u};
      }
  }
  float transmittance(vec3 p) const { return shared::decode_map(view_of(flat, texels.data()).scene, 0, p); }
  /// Largest error over depths in [0, 2] along the middle of the slab, against e^(-sigma_t depth).
  double worst_error(float sigma_t) const {
    double worst = 0.0;
    for (int i = 0; i <= 400; ++i) {
      const float depth = float(i) / 200.0f;
      worst = std::max(
          worst, std::abs(transmittance({0.1f, -0.2f, 1.0f - depth}) - std::exp(-double(sigma_t) * depth)));
    }
    return worst;
  }
};

MapQuality quality(Encoding encoding, int coefficients, float weighting = 1.0f) {
  MapQuality q;
  q.encoding = encoding;
  q.coefficients = coefficients;
  q.density_weighting = weighting;
  return q;
}

/// What n coefficients leave out of e^(-a x) on [0, 1] at its worst point, x = 0: the sum of the others.
double truncation(double a, int n) {
  double sum = 0.0;
  for (double j = n; j < 1e5; ++j)
    sum += 2.0 * a * (1.0 - std::cos(j * M_PI) * std::exp(-a)) / (a * a + j * j * M_PI * M_PI);
  return sum;
}

TEST(LightMarch, ThinMediaAreOffByWhatTheSeriesLeavesOutAndByNoMore) {
  for (const int coefficients : {4, 6, 14, 16}) {
    const double error = Slab(1.0f, quality(Encoding::atfm, coefficients)).worst_error(1.0f);
    EXPECT_LE(error, truncation(2.0, coefficients) + 1e-3) << coefficients;
    EXPECT_GE(error, 0.75 * truncation(2.0, coefficients)) << coefficients;
  }
}

TEST(LightMarch, AdaptationKeepsDenseMediaSharpWhereTheFullRangeCannot) {
  const float sigma_t = 200.0f;
  const double full = Slab(sigma_t, quality(Encoding::tfm, 6)).worst_error(sigma_t);
  const double adaptive = Slab(sigma_t, quality(Encoding::atfm, 6)).worst_error(sigma_t);
  // One mean free path in, where e^-1 is left, six terms over 400 mean free paths hold next to nothing.
  EXPECT_GT(full, 0.25);
  EXPECT_LT(adaptive, truncation(-std::log(0.02), 6) + 0.02) << "0.02: light behind the threshold is cut";
}

TEST(LightMarch, WeightingMakesTheSteepEndGentler) {
  const double plain = Slab(30.0f, quality(Encoding::atfm, 6, 1.0f)).worst_error(30.0f);
  const double weighted = Slab(30.0f, quality(Encoding::atfm, 6, 2.0f)).worst_error(30.0f);
  EXPECT_LT(weighted, plain);
}

TEST(LightMarch, TheProjectionIsTheClosedFormCosineIntegral) {
  // T = e^(-a x) on [0, 1]: c_j = 2 a (1 - (-1)^j e^-a) / (a^2 + (j pi)^2), c_0 = (1 - e^-a) / a.
  MapQuality q = quality(Encoding::tfm, 6);
  q.refine_steps = 512;
  const float sigma_t = 1.5f;
  const Slab slab(sigma_t, q);
  const MarchViews views = view_of(slab.flat, nullptr);
  float c[16];
  const vec2 middle(0.5f);
  const uint bounds = shared::encode_texel(views.scene, shared::map_ray_origin(views.scene, 0, middle),
                                           shared::map_ray_direction(views.scene, 0, middle), 0,
                                           slab.flat.maps[0].k_max, slab.flat.encode, c);
  const double range = shared::bounds_k_max(bounds, slab.flat.maps[0].k_max) -
                       shared::bounds_k_min(bounds, slab.flat.maps[0].k_max);
  EXPECT_NEAR(range, 2.0, 1e-3);
  const double a = sigma_t * 2.0;
  EXPECT_NEAR(c[0], (1.0 - std::exp(-a)) / a, 2e-4);
  for (int j = 1; j < 6; ++j)
    EXPECT_NEAR(c[j], 2.0 * a * (1.0 - std::cos(j * M_PI) * std::exp(-a)) / (a * a + j * j * M_PI * M_PI),
                3e-4)
        << j;
}

TEST(LightMarch, NothingGetsThroughBehindADenseBallAndAllBesideIt) {
  const Slab ball(300.0f, quality(Encoding::atfm, 6), MediumShape::sphere);
  EXPECT_EQ(ball.transmittance({0.0f, 0.0f, -0.99f}), 0.0f);
  EXPECT_NEAR(ball.transmittance({0.0f, 0.0f, 1.0f}), 1.0f, 1e-3f);
  EXPECT_EQ(ball.transmittance({0.97f, 0.97f, -0.5f}), 1.0f);
}

TEST(LightMarch, LastValueIsThePublishedEndAndLeaksLight) {
  MapQuality q = quality(Encoding::atfm, 6);
  q.end_rule = EndRule::last_value;
  const Slab leaking(300.0f, q, MediumShape::sphere);
  EXPECT_GT(leaking.transmittance({0.0f, 0.0f, -0.9f}), 1e-4f);
}

TEST(LightMarch, ADropInTheFirstStepStillHasARange) {
  const Slab opaque(1e6f, quality(Encoding::atfm, 6));
  EXPECT_EQ(opaque.transmittance({0.0f, 0.0f, 0.9f}), 0.0f);
  EXPECT_NEAR(opaque.transmittance({0.0f, 0.0f, 1.0f}), 1.0f, 0.05f);
}

TEST(LightMarch, AVeilInFrontDoesNotWidenTheRangeOfTheCore) {
  // A veil of optical depth 0.02 in front of a dense core.
  MapQuality q = quality(Encoding::atfm, 6);
  const auto error = [&](KminRule rule) {
    q.kmin_rule = rule;
    Slab scene(60.0f, q);
    scene.snapshot.media[0].world_from_medium =
        glm::scale(glm::translate(dmat4(1.0), dvec3(0, 0, -1)), dvec3(1, 1, 0.5));
    Medium veil = scene.snapshot.media[0];
    veil.world_from_medium = glm::translate(dmat4(1.0), dvec3(0, 0, 3));
    veil.sigma_s = veil.sigma_a = vec3(0.005f);
    scene.snapshot.media.push_back(veil);
    scene.encode();
    double worst = 0.0;
    for (int i = 0; i < 100; ++i) {
      const double depth = i * 0.001;
      worst = std::max(
          worst, std::abs(scene.transmittance({0, 0, float(-0.5 - depth)}) - std::exp(-0.02 - 60.0 * depth)));
    }
    return worst;
  };
  EXPECT_LT(error(KminRule::veil_proof), truncation(-std::log(0.02), 6) + 0.02);
  EXPECT_GT(error(KminRule::first_density), 3.0 * error(KminRule::veil_proof));
}

TEST(LightMarch, ColouredExtinctionIsAPowerOfOneScalar) {
  Slab slab(1.0f, quality(Encoding::atfm, 14));
  slab.snapshot.media[0].sigma_s = {0.5f, 1.0f, 2.0f};
  slab.snapshot.media[0].sigma_a = {0.5f, 1.0f, 0.0f};
  slab.encode();
  EXPECT_EQ(slab.flat.group_count, 1);
  EXPECT_FLOAT_EQ(slab.flat.media[0].sigma_group, 1.0f);
  EXPECT_NEAR(slab.flat.maps[0].exponent.y, 2.0f, 1e-6f);
  EXPECT_NEAR(slab.transmittance({0, 0, 0.0f}), std::exp(-1.0), 0.01) << "the smallest channel is stored";
}

}  // namespace
}  // namespace plinian
