#include "core/shared/cosine_texel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/shared/map_decode.h"

namespace plinian {
namespace {

using namespace shared;

TEST(CosineTexel, CosineOfPiIsExactToSevenDigits) {
  for (int i = 0; i <= 1000; ++i) {
    const double x = i / 1000.0;
    EXPECT_NEAR(cos_pi(float(x)), std::cos(x * M_PI), 4e-7) << x;
  }
}

TEST(CosineTexel, BoundsAreWidenedNeverNarrowedAndKeepTheFlag) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  for (int i = 0; i < 10000; ++i) {
    const float depth = 10.0f + 300.0f * unit(random);
    float a = depth * unit(random), b = depth * unit(random);
    if (a > b) std::swap(a, b);
    const bool dense = i % 2;
    const uint bits = pack_bounds(a, b, dense, depth);
    const float step = depth / 65535.0f;
    EXPECT_LE(bounds_k_min(bits, depth), a + 1e-3f * step);
    EXPECT_GE(bounds_k_max(bits, depth), b - 3e-3f * step);
    EXPECT_LT(bounds_k_max(bits, depth) - b, 3.01f * step);
    EXPECT_GT(bounds_k_max(bits, depth), bounds_k_min(bits, depth));
    EXPECT_EQ(bounds_dense(bits), dense);
  }
}

/// A map of 2 x 2 equal texels, decoded at its middle.
struct OneTexel {
  std::vector<uvec4> texels;
  MapData map{};
  MarchScene scene;
  OneTexel(std::array<float, 16> c, uint bounds, int coefficients, float weighting, float depth) {
    const int words = words_per_texel(coefficients);
    const auto pair = [&](int j) { return glm::packHalf2x16(vec2(c[j], c[j + 1])); };
    for (int t = 0; t < 4; ++t) {
      texels.push_back({pair(0), pair(2), pair(4), bounds});
      if (words > 1) texels.push_back({pair(6), pair(8), pair(10), pair(12)});
      if (words > 2) texels.push_back({pair(14), 0u, 0u, 0u});
    }
    map.row_u = {0, 0, 0, 0.5f};
    map.row_v = {0, 0, 0, 0.5f};
    map.row_k = {0, 0, 1, 0};  // k = z
    map.k_max = depth;
    scene.maps = &map;
    scene.texels = texels.data();
    scene.layout = {2, coefficients, weighting};
  }
  float at(float k) const { return decode_map(scene, 0, vec3(0, 0, k)); }
};

TEST(CosineTexel, SumsItsSeriesForEveryNumberOfCoefficients) {
  for (const int coefficients : {2, 5, 6, 7, 13, 14, 15, 16}) {
    std::array<float, 16> c{};
    for (int j = 0; j < coefficients; ++j) c[j] = 0.4f / float(1 + j * j) * (j % 3 == 1 ? -0.5f : 1.0f);
    const float depth = 65535.0f;  // a step of the bounds is one unit
    const OneTexel texel(c, 100u | (1100u << 16), coefficients, 1.0f, depth);
    for (const float k : {100.5f, 300.0f, 655.25f, 1099.0f}) {
      double sum = 0.0;
      for (int j = 0; j < coefficients; ++j) {
        const float half = glm::unpackHalf2x16(glm::packHalf2x16(vec2(c[j], 0))).x;
        sum += half * std::cos(j * M_PI * (k - 100.0) / 1000.0);
      }
      EXPECT_NEAR(texel.at(k), std::min(std::max(sum, 0.0), 1.0), 2e-5) << coefficients << " " << k;
    }
  }
}

TEST(CosineTexel, IsOneInFrontOfItsBoundsAndZeroBehindDenseOnes) {
  std::array<float, 16> c{};
  c[0] = 0.3f;
  const OneTexel dense(c, 1000u | (2001u << 16), 6, 1.0f, 65535.0f);
  EXPECT_EQ(dense.at(10.0f), 1.0f);
  EXPECT_EQ(dense.at(2002.0f), 0.0f);
  EXPECT_NEAR(dense.at(1500.0f), 0.3f, 1e-3f);
  const OneTexel thin(c, 1000u | (2000u << 16), 6, 1.0f, 65535.0f);
  EXPECT_NEAR(thin.at(30000.0f), 0.3f, 1e-3f) << "behind a thin range the last value holds";
  const OneTexel weighted(c, 1000u | (2000u << 16), 6, 3.0f, 65535.0f);
  EXPECT_NEAR(weighted.at(1500.0f), 0.027f, 1e-4f);
}

TEST(CosineTexel, RaysThatMissEveryMediumLetAllLightThrough) {
  const OneTexel missed({}, missed_bounds(), 6, 2.0f, 65535.0f);
  for (const float k : {0.0f, 1.0f, 40000.0f, 65534.0f}) EXPECT_EQ(missed.at(k), 1.0f);
}

}  // namespace
}  // namespace plinian
