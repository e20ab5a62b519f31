#include "host/graph/values/ramp.h"

#include <gtest/gtest.h>

namespace plinian::graph {
namespace {

TEST(Ramp, HoldsItsEndsAndPassesThroughItsPoints) {
  for (const Interpolation kind : {Interpolation::stepped, Interpolation::linear, Interpolation::smooth}) {
    const Ramp ramp{{{0.0f, vec3(1.0f), kind}, {0.5f, vec3(3.0f), kind}, {1.0f, vec3(4.0f), kind}}};
    EXPECT_EQ(evaluate(ramp, -1.0f), vec3(1.0f));
    EXPECT_EQ(evaluate(ramp, 2.0f), vec3(4.0f));
    EXPECT_NEAR(evaluate(ramp, 0.5f).x, 3.0f, 1e-6f);
  }
  EXPECT_EQ(evaluate(Ramp{}, 0.5f), vec3(0.0f));
}

TEST(Ramp, StepsHoldLinesAreStraightAndSmoothCurvesNeverOvershoot) {
  const auto ramp = [](Interpolation kind) {
    return Ramp{{{0.0f, vec3(0.0f), kind}, {1.0f, vec3(1.0f), kind}, {2.0f, vec3(1.0f), kind}}};
  };
  EXPECT_EQ(evaluate(ramp(Interpolation::stepped), 0.9f).x, 0.0f);
  EXPECT_FLOAT_EQ(evaluate(ramp(Interpolation::linear), 0.25f).x, 0.25f);
  float last = 0.0f;
  for (float x = 0.0f; x <= 2.0f; x += 0.01f) {
    const float y = evaluate(ramp(Interpolation::smooth), x).x;
    EXPECT_GE(y, last - 1e-6f);
    EXPECT_LE(y, 1.0f + 1e-6f);
    last = y;
  }
}

TEST(Ramp, AMonotoneCubicReproducesAStraightLine) {
  const std::vector<double> x = {0.0, 1.0, 3.0, 4.0}, y = {1.0, 3.0, 7.0, 9.0};
  const auto m = monotone_slopes(x, y);
  EXPECT_NEAR(m[1], 2.0, 1e-12);
  EXPECT_NEAR(hermite(1.0, 3.0, m[1], 3.0, 7.0, m[2], 2.5), 6.0, 1e-12);
}

}  // namespace
}  // namespace plinian::graph
