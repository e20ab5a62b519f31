#include "core/image/flip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plinian {
namespace {

using Picture = std::vector<vec3>;

Picture flat(int width, int height, vec3 colour) {
  return Picture(std::size_t(width) * std::size_t(height), colour);
}

float flat_flip(vec3 a, vec3 b) {
  return flip(flat(24, 16, a), flat(24, 16, b), 24, 16).mean;
}

// Three channels of structure at all scales, different for every `kind`.
Picture structured(int size, int kind) {
  Picture picture;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      picture.push_back(kind == 0 ? vec3(float((x * 7 + y * 3) % 11) / 10.0f,
                                         float((x * 5 + y * 2) % 7) / 6.0f, float((x + y * 4) % 5) / 4.0f)
                                  : vec3(float((x * 7 + y * 3) % 13) / 12.0f,
                                         float((x * 3 + y * 2) % 7) / 6.0f, float((x + y * 3) % 5) / 4.0f));
  return picture;
}

TEST(Flip, EqualPicturesDoNotDiffer) {
  const Picture picture = structured(33, 0);
  const FlipResult result = flip(picture, picture, 33, 33);
  EXPECT_EQ(result.mean, 0.0f);
  EXPECT_EQ(result.max, 0.0f);
}

TEST(Flip, IsSymmetric) {
  const Picture a = structured(33, 0), b = structured(33, 1);
  const FlipResult ab = flip(a, b, 33, 33), ba = flip(b, a, 33, 33);
  EXPECT_GT(ab.mean, 0.1f);
  EXPECT_EQ(ab.map, ba.map);
}

TEST(Flip, GreenAgainstBlueIsTheLargestDifference) {
  EXPECT_NEAR(flat_flip(vec3(0, 1, 0), vec3(0, 0, 1)), 1.0f, 1e-5f);
  EXPECT_LT(flat_flip(vec3(1, 0, 0), vec3(0, 1, 0)), 1.0f);
}

TEST(Flip, BlackAgainstWhiteIsItsClosedForm) {
  // Lightness differs by 100 and chroma by nothing: 100^0.7 = 25.1189. Green against blue: 41.2755, 0.4 of
  // it 16.5102. 0.95 + 0.05 (25.1189 - 16.5102) / (41.2755 - 16.5102) = 0.96738.
  EXPECT_NEAR(flat_flip(vec3(0.0f), vec3(1.0f)), 0.96738f, 2e-5f);
}

TEST(Flip, ASmallGreyStepIsItsClosedForm) {
  // L* of 0.2 and 0.25 are 51.837 and 57.075; (5.2386)^0.7 = 3.1872 and 0.95 / 16.5102 of that is 0.18340.
  EXPECT_NEAR(flat_flip(vec3(0.2f), vec3(0.25f)), 0.18340f, 2e-5f);
}

TEST(Flip, FlatColoursHaveTheValuesOfAnIndependentEvaluation) {
  EXPECT_NEAR(flat_flip(vec3(1, 0, 0), vec3(0, 1, 0)), 0.986662f, 1e-5f);
  EXPECT_NEAR(flat_flip(vec3(0.8f, 0.3f, 0.05f), vec3(0.7f, 0.35f, 0.05f)), 0.263464f, 1e-5f);
}

TEST(Flip, ExposureIsAFactorAndThePictureIsClipped) {
  const Picture a = flat(16, 16, vec3(0.05f)), b = flat(16, 16, vec3(0.0625f));
  FlipSettings settings;
  settings.exposure = 2.0f;
  EXPECT_NEAR(flip(a, b, 16, 16, settings).mean, 0.18340f, 2e-5f);  // 0.2 against 0.25
  settings.exposure = 6.0f;
  EXPECT_EQ(flip(a, b, 16, 16, settings).mean, 0.0f) << "both are white";
}

// Literals from an evaluation of the paper's formulas with unseparated 21 x 21 and 19 x 19 filters in double
// precision, written apart from this code.
TEST(Flip, AWhiteDotOnBlackHasTheValuesOfABruteForceEvaluation) {
  const int n = 41;
  const Picture black = flat(n, n, vec3(0.0f));
  Picture dot = black;
  dot[20 * n + 20] = vec3(1.0f);
  const FlipResult result = flip(black, dot, n, n);
  EXPECT_NEAR(result.map[20 * n + 20], 0.864921f, 1e-4f);
  EXPECT_NEAR(result.map[20 * n + 22], 0.480564f, 1e-4f);
  EXPECT_NEAR(result.map[20 * n + 25], 0.001260f, 1e-4f);
  EXPECT_NEAR(result.map[23 * n + 22], 0.043044f, 1e-4f);
  EXPECT_EQ(result.max, result.map[20 * n + 20]);
}

TEST(Flip, AShiftedColourEdgeHasTheValuesOfABruteForceEvaluation) {
  const int n = 41;
  const auto edge = [&](int at) {
    Picture picture;
    for (int i = 0; i < n * n; ++i)
      picture.push_back(i % n < at ? vec3(0.9f, 0.4f, 0.1f) : vec3(0.1f, 0.2f, 0.6f));
    return picture;
  };
  const FlipResult result = flip(edge(20), edge(22), n, n);
  EXPECT_NEAR(result.map[20 * n + 20], 0.694580f, 1e-4f);
  EXPECT_NEAR(result.map[20 * n + 24], 0.300920f, 1e-4f);
  EXPECT_NEAR(result.map[16], 0.356042f, 1e-4f) << "on the upper border";
}

TEST(Flip, StructureEverywhereHasTheValuesOfABruteForceEvaluation) {
  const int n = 41;
  const FlipResult result = flip(structured(n, 0), structured(n, 1), n, n);
  EXPECT_NEAR(result.map[20 * n + 20], 0.221981f, 1e-4f);
  EXPECT_NEAR(result.map[0], 0.209367f, 1e-4f) << "in the corner";
  EXPECT_NEAR(result.map[13 * n + 40], 0.293392f, 1e-4f) << "on the right border";
}

TEST(Flip, NoiseFadesWithTheViewersDistance) {
  Picture checker, grey = flat(64, 64, vec3(0.5f));
  for (int i = 0; i < 64 * 64; ++i) checker.push_back(vec3((i + i / 64) % 2 ? 0.55f : 0.45f));
  FlipSettings near, far;
  near.pixels_per_degree = 15.0f;
  far.pixels_per_degree = 120.0f;
  EXPECT_GT(flip(checker, grey, 64, 64, near).mean, 5.0f * flip(checker, grey, 64, 64, far).mean);
}

TEST(Flip, APictureOfOnePixelIsMeasured) {
  EXPECT_NEAR(flip(flat(1, 1, vec3(0.0f)), flat(1, 1, vec3(1.0f)), 1, 1).mean, 0.96738f, 2e-5f);
}

}  // namespace
}  // namespace plinian
