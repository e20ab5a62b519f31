#include "core/media/blackbody.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plinian {
namespace {

double luminance(vec3 rgb) {
  return 0.2126729 * rgb.x + 0.7151522 * rgb.y + 0.0721750 * rgb.z;
}

/// CIE 1931 chromaticity of a linear Rec.709 colour (IEC 61966-2-1).
glm::dvec2 chromaticity(vec3 rgb) {
  const double x = 0.4124564 * rgb.x + 0.3575761 * rgb.y + 0.1804375 * rgb.z;
  const double y = luminance(rgb);
  const double z = 0.0193339 * rgb.x + 0.1191920 * rgb.y + 0.9503041 * rgb.z;
  return glm::dvec2(x, y) / (x + y + z);
}

TEST(Blackbody, LiesOnThePlanckianLocus) {
  // Tabulated locus (Wyszecki and Stiles, Color Science); 2856 K is CIE illuminant A. The observer's fit is
  // good to about 0.002.
  const struct {
    double kelvin, x, y;
  } locus[] = {{2000, 0.5267, 0.4133},
               {2856, 0.4476, 0.4074},
               {4000, 0.3805, 0.3768},
               {6500, 0.3135, 0.3237},
               {10000, 0.2807, 0.2884}};
  for (const auto& [kelvin, x, y] : locus) {
    const glm::dvec2 found = chromaticity(planck_colour(kelvin));
    EXPECT_NEAR(found.x, x, 0.003) << kelvin << " K";
    EXPECT_NEAR(found.y, y, 0.003) << kelvin << " K";
  }
}

TEST(Blackbody, HasLuminanceOneAndNoNegativeChannelAtAnyTemperature) {
  for (const double kelvin : {-5.0, 0.0, 50.0, 300.0, 700.0, 1000.0, 1500.0, 1900.0, 5000.0, 40000.0, 1e6}) {
    const vec3 colour = planck_colour(kelvin);
    EXPECT_NEAR(luminance(colour), 1.0, 1e-5) << kelvin << " K";
    EXPECT_GE(glm::min(colour.x, glm::min(colour.y, colour.z)), 0.0f) << kelvin << " K";
  }
}

TEST(Blackbody, TurnsFromRedToBlueAsItHeats) {
  EXPECT_EQ(planck_colour(600.0), vec3(float(1.0 / 0.2126729), 0.0f, 0.0f));  // the gamut's own red
  float last = -1.0f;
  for (double kelvin = 2000.0; kelvin < 12000.0; kelvin *= 1.1) {
    const vec3 colour = planck_colour(kelvin);
    EXPECT_GT(colour.z / colour.x, last) << kelvin << " K";
    last = colour.z / colour.x;
  }
}

TEST(Blackbody, TableFollowsThePlanckColour) {
  for (float kelvin = 500.0f; kelvin <= 12000.0f; kelvin += 3.7f) {
    const vec3 exact = planck_colour(kelvin), table = blackbody_colour(kelvin);
    const float largest = glm::max(exact.x, glm::max(exact.y, exact.z));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(table[c], exact[c], 0.003f * largest) << kelvin << " K";
  }
}

TEST(Blackbody, TableEndsAreHeldAndNothingIsNotANumber) {
  EXPECT_EQ(blackbody_colour(0.0f), vec3(blackbody_table().front()));
  EXPECT_EQ(blackbody_colour(1e9f), vec3(blackbody_table().back()));
  EXPECT_EQ(blackbody_colour(std::numeric_limits<float>::quiet_NaN()), vec3(blackbody_table().front()));
}

TEST(Blackbody, RadianceGrowsWithTheFourthPowerFrom1800Kelvin) {
  EXPECT_FLOAT_EQ(shared::blackbody_gain(1800.0f), 1.0f);
  EXPECT_FLOAT_EQ(shared::blackbody_gain(3600.0f), 16.0f);
  EXPECT_EQ(shared::blackbody_gain(-10.0f), 0.0f);
  EXPECT_EQ(shared::blackbody_gain(std::numeric_limits<float>::quiet_NaN()), 0.0f);
}

}  // namespace
}  // namespace plinian
