#include "core/image/heat_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/shared/view_curve.h"

namespace plinian {
namespace {

float lightness(vec3 shown) {  // CIE L* [0, 100]
  const float y = 0.2126f * shared::linear_from_srgb(shown.r) + 0.7152f * shared::linear_from_srgb(shown.g) +
                  0.0722f * shared::linear_from_srgb(shown.b);
  return y > 0.008856f ? 116.0f * std::cbrt(y) - 16.0f : 903.3f * y;
}

TEST(HeatMap, LightnessRisesEvenlyFromBlackToNearWhite) {
  EXPECT_LT(lightness(heat_colour(0.0f)), 1.0f);
  EXPECT_GT(lightness(heat_colour(1.0f)), 95.0f);
  for (int i = 0; i < 100; ++i) {
    const float step =
        lightness(heat_colour(float(i + 1) / 100.0f)) - lightness(heat_colour(float(i) / 100.0f));
    EXPECT_GT(step, 0.3f) << i;
    EXPECT_LT(step, 2.0f) << i;
  }
}

TEST(HeatMap, ValuesOutsideAreClampedAndNaNStandsOut) {
  EXPECT_EQ(heat_colour(-3.0f), heat_colour(0.0f));
  EXPECT_EQ(heat_colour(7.0f), heat_colour(1.0f));
  EXPECT_EQ(heat_colour(std::numeric_limits<float>::quiet_NaN()), vec3(0, 1, 1));
}

TEST(HeatMap, BytesAreScaled) {
  const std::vector<float> values{0.0f, 2.0f};
  const std::vector<std::uint8_t> bytes = heat_bytes(values, 2.0f);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0x00, 0x00, 0x04, 0xfc, 0xfd, 0xbf}));
}

TEST(HeatMap, TheFullScaleIsRoundAndForgivesAHandfulOfOutliers) {
  std::vector<float> values(2000, 0.013f);
  values[7] = 100.0f;
  EXPECT_FLOAT_EQ(heat_full_scale(values), 0.02f);
  values.assign(2000, 0.02f);
  EXPECT_FLOAT_EQ(heat_full_scale(values), 0.02f);
  values.assign(2000, 7.0f);
  EXPECT_FLOAT_EQ(heat_full_scale(values), 10.0f);
  values.assign(2000, 0.0f);
  EXPECT_FLOAT_EQ(heat_full_scale(values), 1e-6f);
}

}  // namespace
}  // namespace plinian
