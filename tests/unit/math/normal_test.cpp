/// The normal distribution against published values and its own inverse.
#include "parapet/math/normal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace parapet::math {
namespace {

// Published values of the normal distribution, in the middle and in both tails.
TEST(NormalQuantile, GivesPublishedValues) {
  EXPECT_EQ(normal_quantile(0.5), 0.0);
  // 1e-14 relative: the algorithm states 1e-16, the values here have 16 digits.
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 2e-14);
  EXPECT_NEAR(normal_quantile(0.025), -1.959963984540054, 2e-14);
  EXPECT_NEAR(normal_quantile(0.841344746068542949), 1.0, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-13);
}

// It is the inverse of the distribution function, through all three of its branches.
TEST(NormalQuantile, InvertsTheDistributionFunction) {
  for (const double p : {1e-15, 1e-11, 1e-6, 0.01, 0.0749, 0.0751, 0.3, 0.5, 0.7, 0.9251, 0.999}) {
    // erfc is good to a few units in the last place, times the slope of log p in the tails.
    EXPECT_NEAR(normal_cdf(normal_quantile(p)) / p, 1.0, 1e-13) << p;
  }
}

TEST(NormalQuantile, GivesTheCheckValuesOfItsSource) {
  // The check values that Wichura prints with AS 241, to its 16 figures.
  EXPECT_NEAR(normal_quantile(0.25), -0.6744897501960817, 1e-15);
  EXPECT_NEAR(normal_quantile(0.001), -3.090232306167814, 3e-15);
  EXPECT_NEAR(normal_quantile(1e-20), -9.262340089798408, 1e-14);
  EXPECT_EQ(normal_quantile(0.5), 0.0);
}

TEST(NormalQuantile, InvertsFromTheArgument) {
  for (double t = -8.0; t < 5.0; t += 0.37) {
    // Phi's rounding is worth eps Phi / phi in t: below 1e-9 up to t = 5.
    EXPECT_NEAR(normal_quantile(normal_cdf(t)), t, 1e-9) << t;
  }
}

TEST(NormalCdf, LogarithmAndHazardHoldInTheFarTail) {
  // On both sides of the switch between erfc and Mills' ratio, where erfc still has its digits: a
  // rounding of exp(-t^2 / 2) is t^2 / 2 units of 1e-16.
  for (const double t : {-24.999, -10.001, -9.999, -3.0, -0.001, 0.001, 3.0}) {
    EXPECT_NEAR(log_normal_cdf(t), std::log(normal_cdf(t)), 1e-13) << t;
    const double density = std::exp(-0.5 * t * t - 0.5 * std::log(2 * std::numbers::pi));
    EXPECT_NEAR(normal_hazard(t) / (density / normal_cdf(t)), 1.0, 2e-13) << t;
  }
  // Phi(t) lies between phi(t) / |t| (1 - 1 / t^2) and phi(t) / |t|.
  const double t = -1e6;
  const double upper = -0.5 * t * t - 0.5 * std::log(2 * std::numbers::pi) - std::log(-t);
  EXPECT_NEAR(log_normal_cdf(t), upper, 1e-9 * std::abs(upper));
  EXPECT_NEAR(normal_hazard(t), 1e6 + 1e-6, 1e-9);  // -t + 1 / -t + ...
  EXPECT_LT(log_normal_cdf(6.0), 0.0);
  EXPECT_NEAR(log_normal_cdf(6.0), -normal_cdf(-6.0), 1e-17);
}

}  // namespace
}  // namespace parapet::math
