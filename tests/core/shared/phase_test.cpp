#include "core/shared/phase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace plinian {
namespace {

/// Integral over the sphere of f(cosine): 2 pi times Simpson's rule in the cosine.
double over_sphere(const std::function<double(double)>& f) {
  constexpr int intervals = 200000;
  double sum = 0.0;
  for (int i = 0; i <= intervals; ++i) {
    const double weight = (i == 0 || i == intervals) ? 1.0 : (i % 2 ? 4.0 : 2.0);
    sum += weight * f(-1.0 + 2.0 * i / intervals);
  }
  return 2.0 * std::numbers::pi * sum * (2.0 / intervals) / 3.0;
}

struct Moments {
  double total;        // [-] integral over the sphere
  double mean_cosine;  // [-]
};

Moments moments(int kind, float g, float g_back = 0.0f, float blend = 0.0f) {
  const auto p = [=](double c) {
    return double(shared::phase_function(kind, static_cast<float>(c), g, g_back, blend));
  };
  return {over_sphere(p), over_sphere([&](double c) { return c * p(c); })};
}

TEST(Phase, IsotropicIsOneOverFourPiAndHasNoPreferredDirection) {
  const Moments m = moments(shared::phase_isotropic, 0.7f);
  EXPECT_FLOAT_EQ(shared::phase_function(shared::phase_isotropic, 0.3f, 0.7f, 0.0f, 0.0f), 0.0795774715f);
  EXPECT_NEAR(m.total, 1.0, 1e-6);
  EXPECT_NEAR(m.mean_cosine, 0.0, 1e-6);
}

TEST(Phase, HenyeyGreensteinIntegratesToOneWithMeanCosineG) {
  for (const float g : {-0.9f, -0.5f, -0.1f, 0.0f, 0.3f, 0.6f, 0.95f}) {
    const Moments m = moments(shared::phase_henyey_greenstein, g);
    EXPECT_NEAR(m.total, 1.0, 1e-4) << "g = " << g;
    EXPECT_NEAR(m.mean_cosine, g, 1e-4) << "g = " << g;
  }
}

TEST(Phase, HenyeyGreensteinSendsLightForwardWhenGIsPositive) {
  // (1 - g^2) / (1 - g)^3 = 6 and (1 - g^2) / (1 + g)^3 = 2/9 at g = 1/2.
  EXPECT_FLOAT_EQ(shared::henyey_greenstein(1.0f, 0.5f), 6.0f / (4.0f * std::numbers::pi_v<float>));
  EXPECT_FLOAT_EQ(shared::henyey_greenstein(-1.0f, 0.5f), 2.0f / (36.0f * std::numbers::pi_v<float>));
}

TEST(Phase, SchlickIntegratesToOneWithTheMeanCosineOfItsEllipse) {
  for (const float g : {-0.8f, -0.3f, 0.2f, 0.5f, 0.9f}) {
    const Moments m = moments(shared::phase_schlick, g);
    const double k = 1.55 * g - 0.55 * std::pow(double(g), 3.0);
    const double mean = 1.0 / k - (1.0 - k * k) / (2.0 * k * k) * std::log((1.0 + k) / (1.0 - k));
    EXPECT_NEAR(m.total, 1.0, 1e-4) << "g = " << g;
    EXPECT_NEAR(m.mean_cosine, mean, 1e-4) << "g = " << g;
  }
}

TEST(Phase, TwoLobesBlendTheirMeanCosines) {
  const Moments m = moments(shared::phase_two_lobe, 0.8f, -0.4f, 0.25f);
  EXPECT_NEAR(m.total, 1.0, 1e-4);
  EXPECT_NEAR(m.mean_cosine, 0.75 * 0.8 - 0.25 * 0.4, 1e-4);
}

}  // namespace
}  // namespace plinian
