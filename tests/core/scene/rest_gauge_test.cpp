// How the end of a refinement is found, on pictures whose way to their limit is known.
#include "core/scene/rest_gauge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/shared/view_curve.h"

namespace plinian {
namespace {

Frame frame_of(std::vector<vec3> beauty, float alpha = 1.0f) {
  Frame frame;
  frame.width = int(beauty.size());
  frame.height = 1;
  frame.transmittance.assign(beauty.size(), vec3(1.0f - alpha));
  frame.beauty = std::move(beauty);
  return frame;
}

float radiance_of_step(double step) {
  return shared::linear_from_srgb(float(step / 255.0));
}

TEST(RestGauge, LooksWhereHalfAsManyPassesWereLookedAt) {
  std::vector<int> looks;
  for (int n = 1; n <= 48; ++n)
    if (RestGauge::looks_at(n)) looks.push_back(n);
  EXPECT_EQ(looks, (std::vector<int>{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48}));
}

// A first pass that is off by d steps and others that are exact: after n passes the picture is off by d / n.
TEST(RestGauge, IsExactWhereTheErrorFallsWithThePasses) {
  RestGauge gauge;
  // In the linear part of the display's curve, where steps add; one white pixel keeps it from being lifted.
  for (const int n : {1, 2, 3, 4, 6, 8, 12, 16}) {
    std::vector<vec3> beauty(1000, vec3(radiance_of_step(5.0 + 4.0 / n)));
    beauty[0] = beauty[1] = vec3(1.0f);
    const auto change = gauge.look(n, frame_of(beauty));
    EXPECT_EQ(change.has_value(), n != 1 && n != 3);
    if (change) {
      EXPECT_NEAR(*change, 4.0 / n, 0.01 * 4.0 / n);
    }
  }
}

TEST(RestGauge, IsRightOnTheWholeWhereThePassesAreNoise) {
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0.0f, radiance_of_step(1.0));
  constexpr int pixels = 20000;
  std::vector<vec3> sum(pixels, vec3(0.0f));
  RestGauge gauge;
  for (int n = 1; n <= 16; ++n) {
    for (vec3& v : sum) v += vec3(radiance_of_step(6.0)) + vec3(noise(random), noise(random), noise(random));
    if (!RestGauge::looks_at(n)) continue;
    std::vector<vec3> mean = sum;
    for (vec3& v : mean) v /= float(n);
    for (int i = 0; i < 30; ++i) mean[i] = vec3(1.0f);
    if (const auto change = gauge.look(n, frame_of(mean))) {
      EXPECT_NEAR(*change, 1.0 / std::sqrt(double(n)), 0.03 / std::sqrt(double(n))) << n;
    }
  }
}

TEST(RestGauge, LiftsADarkPictureAndLeavesOutWhatShowsNoMedium) {
  const auto change = [](float exposure, float alpha) {
    RestGauge gauge;
    gauge.look(1, frame_of(std::vector<vec3>(100, vec3(0.8f * exposure)), alpha));
    return *gauge.look(2, frame_of(std::vector<vec3>(100, vec3(0.9f * exposure)), alpha));
  };
  EXPECT_NEAR(change(1e-4f, 1.0f), change(1.0f, 1.0f), 1e-3);
  EXPECT_EQ(change(1.0f, 0.005f), 0.0f);
  EXPECT_GT(change(1.0f, 0.02f), 1.0f);
}

TEST(Refinement, EndsAtRestAtTheMostOrWhenTold) {
  const auto passes_taken = [](Passes passes) {
    Refinement refinement(passes);
    // Half of the picture is white, the other half is off by 8 / n steps after n passes.
    const auto mean = [](int n) {
      std::vector<vec3> beauty(20, vec3(1.0f));
      std::fill_n(beauty.begin(), 10, vec3(radiance_of_step(1.0 + 8.0 / n)));
      return frame_of(beauty);
    };
    int n = 0;
    do ++n;
    while (refinement.wants_another(n, [&] { return mean(n); }));
    return n;
  };
  EXPECT_EQ(passes_taken(7), 7) << "a plain number is exact";
  EXPECT_EQ(passes_taken(Passes(100, 1.0f)), 6) << "8 / (6 sqrt 2) steps, the first under 1";
  EXPECT_EQ(passes_taken(Passes(5, 1.0f)), 5);
  EXPECT_EQ(passes_taken(Passes(100, 0.0f)), 100);
  Passes told(100, 1e-6f);
  std::vector<int> known;
  told.after_pass = [&](int done, std::optional<float> change) {
    if (change) known.push_back(done);
    return done < 9;
  };
  EXPECT_EQ(passes_taken(told), 9);
  EXPECT_EQ(known, (std::vector<int>{2, 4, 6, 8}));
}

}  // namespace
}  // namespace plinian
