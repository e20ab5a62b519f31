#include "core/shared/light_falloff.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/lights/light.h"

namespace plinian {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// The edge of a spot along +x at a given angle off its axis. All angles in degrees.
float edge_at(double angle, double inner, double outer) {
  return shared::spot_edge(vec3(1.0f, 0.0f, 0.0f),
                           vec3(std::cos(angle * degree), std::sin(angle * degree), 0.0f),
                           shared::squared_chord(static_cast<float>(inner * degree)),
                           shared::squared_chord(static_cast<float>(outer * degree)));
}

TEST(LightFalloff, ConstantsFollowTheSceneEnumeration) {
  EXPECT_EQ(shared::falloff_inverse_square, static_cast<int>(Falloff::inverse_square));
  EXPECT_EQ(shared::falloff_linear, static_cast<int>(Falloff::linear));
  EXPECT_EQ(shared::falloff_none, static_cast<int>(Falloff::none));
}

TEST(LightFalloff, FallsWithTheDistanceAndStopsGrowingInsideTheRadius) {
  EXPECT_FLOAT_EQ(shared::distance_falloff(shared::falloff_inverse_square, 4.0f, 0.5f), 1.0f / 16.0f);
  EXPECT_FLOAT_EQ(shared::distance_falloff(shared::falloff_linear, 4.0f, 0.5f), 0.25f);
  EXPECT_FLOAT_EQ(shared::distance_falloff(shared::falloff_none, 4.0f, 0.5f), 1.0f);
  EXPECT_FLOAT_EQ(shared::distance_falloff(shared::falloff_inverse_square, 0.1f, 0.5f), 4.0f);
  EXPECT_FLOAT_EQ(shared::distance_falloff(shared::falloff_linear, 0.1f, 0.5f), 2.0f);
}

TEST(LightFalloff, StaysFiniteOnALightWithoutARadius) {
  for (const int kind : {shared::falloff_inverse_square, shared::falloff_linear, shared::falloff_none})
    EXPECT_TRUE(std::isfinite(shared::distance_falloff(kind, 0.0f, 0.0f)));
}

TEST(LightFalloff, SpotEdgeIsASmoothstepInTheCosine) {
  const double inner = 15.0, outer = 20.0;
  for (const double angle : {15.5, 17.0, 18.25, 19.9}) {
    const double x = (std::cos(angle * degree) - std::cos(outer * degree)) /
                     (std::cos(inner * degree) - std::cos(outer * degree));
    EXPECT_NEAR(edge_at(angle, inner, outer), x * x * (3.0 - 2.0 * x), 2e-5) << angle << " degrees";
  }
  EXPECT_EQ(edge_at(0.0, inner, outer), 1.0f);
  EXPECT_EQ(edge_at(14.99, inner, outer), 1.0f);
  EXPECT_EQ(edge_at(20.01, inner, outer), 0.0f);
  EXPECT_EQ(edge_at(180.0, inner, outer), 0.0f);
}

TEST(LightFalloff, NarrowConesKeepTheirShape) {
  // Half way in the cosine between 0.05 and 0.1 degrees, where single-precision cosines would leave few
  // steps.
  const double middle = std::sqrt(0.5 * (0.05 * 0.05 + 0.1 * 0.1));
  EXPECT_NEAR(edge_at(middle, 0.05, 0.1), 0.5f, 1e-3f);
}

TEST(LightFalloff, NoPenumbraIsAHardEdgeAndWideConesReachBehindTheLamp) {
  EXPECT_EQ(edge_at(19.99, 20.0, 20.0), 1.0f);
  EXPECT_EQ(edge_at(20.01, 20.0, 20.0), 0.0f);
  EXPECT_EQ(edge_at(130.0, 140.0, 150.0), 1.0f);
  EXPECT_EQ(edge_at(155.0, 140.0, 150.0), 0.0f);
}

}  // namespace
}  // namespace plinian
