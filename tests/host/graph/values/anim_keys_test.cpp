#include "host/graph/values/anim_keys.h"

#include <gtest/gtest.h>

namespace plinian::graph {
namespace {

TEST(AnimKeys, HoldsItsEndsAndRunsBetweenItsKeysAsTheySay) {
  const std::vector<AnimKey> keys = {{30.0, 1.0, Interpolation::linear},
                                     {10.0, 5.0, Interpolation::stepped},
                                     {20.0, 7.0, Interpolation::linear}};
  EXPECT_EQ(evaluate_keys({}, 3.0), 0.0);
  EXPECT_EQ(evaluate_keys(keys, -5.0), 5.0);
  EXPECT_EQ(evaluate_keys(keys, 19.9), 5.0);
  EXPECT_EQ(evaluate_keys(keys, 20.0), 7.0);
  EXPECT_DOUBLE_EQ(evaluate_keys(keys, 25.0), 4.0);
  EXPECT_EQ(evaluate_keys(keys, 99.0), 1.0);
}

TEST(AnimKeys, SmoothKeysNeverOvershootAndLieOnAStraightLineWhereTheKeysDo) {
  const std::vector<AnimKey> rise = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 10.0}, {3.0, 10.0}};
  for (double t = 0.0; t <= 3.0; t += 0.01) {
    EXPECT_GE(evaluate_keys(rise, t), 0.0);
    EXPECT_LE(evaluate_keys(rise, t), 10.0);
  }
  EXPECT_DOUBLE_EQ(evaluate_keys(rise, 1.5), 5.0);
  const std::vector<AnimKey> line = {{0.0, 0.0}, {1.0, 2.0}, {4.0, 8.0}, {5.0, 10.0}};
  EXPECT_NEAR(evaluate_keys(line, 2.5), 5.0, 1e-12);
}

}  // namespace
}  // namespace plinian::graph
