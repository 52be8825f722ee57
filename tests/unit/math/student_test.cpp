/// Student's t against closed forms, published quantiles and its own inverse.
#include "parapet/math/student.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "parapet/math/normal.hpp"

namespace parapet::math {
namespace {

// With 1 degree of freedom it is Cauchy's distribution, with 2 and 4 an algebraic function.
TEST(StudentCdf, IsTheClosedFormOfFewDegreesOfFreedom) {
  for (const double t : {-30.0, -4.3, -1.0, -0.1, 0.0, 0.2, 1.7, 12.0}) {
    // 1e-14: the continued fraction ends at 1e-15, lgamma and the powers add a few roundings.
    EXPECT_NEAR(student_cdf(t, 1.0), 0.5 + std::atan(t) / std::numbers::pi, 1e-14) << t;
    EXPECT_NEAR(student_cdf(t, 2.0), 0.5 + 0.5 * t / std::sqrt(2.0 + t * t), 1e-14) << t;
    const double u = t / std::sqrt(4.0 + t * t);
    EXPECT_NEAR(student_cdf(t, 4.0), 0.5 + 0.25 * u * (3.0 - u * u), 1e-14) << t;
  }
}

TEST(StudentQuantile, GivesPublishedValues) {
  // Printed to three digits behind the point in every table of the distribution.
  EXPECT_NEAR(student_quantile(0.975, 1.0), 12.706, 5e-4);
  EXPECT_NEAR(student_quantile(0.975, 2.0), 4.303, 5e-4);
  EXPECT_NEAR(student_quantile(0.975, 10.0), 2.228, 5e-4);
  EXPECT_NEAR(student_quantile(0.95, 30.0), 1.697, 5e-4);
  EXPECT_EQ(student_quantile(0.5, 3.0), 0.0);
}

TEST(StudentQuantile, InvertsTheDistributionFunction) {
  for (const double freedom : {0.7, 2.5, 9.0, 133.0, 1e5}) {
    for (const double p : {1e-6, 0.025, 0.4, 0.6, 0.999}) {
      // A rounding of lgamma(1e5) is 1e-10 of the front factor.
      EXPECT_NEAR(student_cdf(student_quantile(p, freedom), freedom), p, 1e-9) << freedom;
    }
  }
}

TEST(StudentCdf, BecomesTheNormalDistribution) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(student_cdf(1.3, infinity), normal_cdf(1.3));
  // The next term is (t^3 + t) phi(t) / (4 freedom), below 0.2 / freedom.
  EXPECT_NEAR(student_cdf(1.3, 1e6), normal_cdf(1.3), 2e-7);
  EXPECT_NEAR(student_quantile(0.975, 1e6), normal_quantile(0.975), 3e-6);
}

}  // namespace
}  // namespace parapet::math
