/// Logarithms of normal tails, sums and differences against long double.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "front_checks.hpp"
#include "parapet/acquisition/improvement.hpp"
#include "parapet/math/normal.hpp"
#include "parapet/math/normal_tail.hpp"

namespace parapet::acquisition {

using math::excess_factor;
using math::log_normal_cdf;
namespace {

using Long = long double;
const Long root_half = std::sqrt(0.5L);
const Long log_root_two_pi = 0.5L * std::log(2.0L * std::numbers::pi_v<Long>);

Long density(Long t) {
  return std::exp(-t * t / 2.0L - log_root_two_pi);
}

/// 1 + sum over k of (-1)^k first (first + 2) ... (first + 2 k - 2) / t^(2 k), asymptotic: at
/// |t| = 10 the 45th term is below 1e-19.
Long asymptotic_sum(Long t, int first) {
  Long sum = 0.0L, term = 1.0L;
  for (int k = 0; k < 45; ++k) {
    sum += term;
    term *= -static_cast<Long>(2 * k + first) / (t * t);
  }
  return sum;
}

/// log Phi(t): by erfc, from 10 on by Abramowitz and Stegun 26.2.12.
Long exact_log_cdf(Long t) {
  if (t > -10.0L) return std::log(0.5L * std::erfc(-t * root_half));
  return -t * t / 2.0L - log_root_two_pi - std::log(-t) + std::log(asymptotic_sum(t, 1));
}

/// log(phi(t) + t Phi(t)). The difference multiplies the roundings of long double, which in exp and
/// erfc are some t^2 units of 5e-20, by t^2: to 5e-16 at 10. From
/// there on by the series 1/t^2 - 3/t^4 + 15/t^6 - ... of the same source.
Long exact_log_excess(Long t) {
  if (t > -10.0L) return std::log(density(t) + t * 0.5L * std::erfc(-t * root_half));
  return -t * t / 2.0L - log_root_two_pi - 2.0L * std::log(-t) + std::log(asymptotic_sum(t, 3));
}

/// A few roundings of a logarithm that is added up of three terms.
double rounding(Long exact) {
  return 1e-15 + 4.0 * 2.3e-16 * std::abs(static_cast<double>(exact));
}

const std::array<double, 19> tails = {-1e8,  -1e6,  -1e4,  -300.0, -100.0, -40.5, -39.5,
                                      -38.0, -20.0, -10.5, -9.5,   -5.0,   -2.0,  -1.0,
                                      -0.5,  -1e-3, 0.0,   0.3,    1.0};

TEST(NormalTail, ExcessFactorOverItsWholeRange) {
  double worst = 0.0;
  for (int i = 0; i <= 60000; ++i) {
    const double t = 0.001 * i;
    const Long exact =
        std::exp(exact_log_excess(-static_cast<Long>(t)) +
                 static_cast<Long>(t) * static_cast<Long>(t) / 2.0L + log_root_two_pi);
    worst = std::max(worst, std::abs(static_cast<double>(excess_factor()(t) / exact - 1.0L)));
  }
  // Measured 1.0e-15. A few roundings of double: 4 / (4 + t) squared, seven steps of Horner's
  // scheme; and up to 5e-16 of the value that it is held against.
  EXPECT_LT(worst, 2e-15);
  EXPECT_EQ(excess_factor()(infinity), 0.0);
}

TEST(NormalTail, LogExpectedExcess) {
  for (const double t : tails) {
    const Long exact = exact_log_excess(t);
    EXPECT_NEAR(log_expected_excess(t, 1.0), static_cast<double>(exact), rounding(exact)) << t;
    // sigma scales both.
    const double sigma = 0x1p-20;
    EXPECT_NEAR(log_expected_excess(t * sigma, sigma),
                static_cast<double>(exact + std::log(static_cast<Long>(sigma))),
                rounding(exact) + rounding(14.0L))
        << t;
  }
  EXPECT_NEAR(log_expected_excess(1e9, 1.0), std::log(1e9), 1e-14);
  // -t^2 / 2 is all that is left of it, and still finite.
  EXPECT_NEAR(log_expected_excess(-1e150, 1.0) / -5e299, 1.0, 1e-15);
}

TEST(NormalTail, LogExpectedExcessKnownExactly) {
  EXPECT_EQ(log_expected_excess(2.0, 0.0), std::log(2.0));
  EXPECT_EQ(log_expected_excess(0.0, 0.0), -infinity);
  EXPECT_EQ(log_expected_excess(-2.0, 0.0), -infinity);
  // A standard deviation below all numbers' steps gives the same.
  EXPECT_EQ(log_expected_excess(2.0, 5e-324), std::log(2.0));
  EXPECT_EQ(log_expected_excess(-2.0, 5e-324), -infinity);
}

TEST(NormalTail, LogNormalCdf) {
  for (const double t : tails) {
    const Long exact = exact_log_cdf(t);
    EXPECT_NEAR(log_normal_cdf(t), static_cast<double>(exact), rounding(exact)) << t;
  }
  // Near one only the complement counts: relative to it.
  for (const double t : {2.0, 5.0, 8.0, 20.0}) {
    const auto exact = static_cast<double>(std::log1p(-0.5L * std::erfc(t * root_half)));
    EXPECT_NEAR(log_normal_cdf(t) / exact, 1.0, 1e-13) << t;  // erfc at 14: its condition is t^2
  }
  EXPECT_EQ(log_normal_cdf(-infinity), -infinity);
  EXPECT_EQ(log_normal_cdf(infinity), 0.0);
}

TEST(LogSpace, DifferenceOfNearlyEqualAndFarApart) {
  for (const double gap : {1e-15, 1e-9, 1e-3, 0.5, 0.7, 5.0, 50.0, 800.0}) {
    const auto exact = static_cast<double>(std::log(-std::expm1(-static_cast<Long>(gap))));
    EXPECT_NEAR(log_difference(0.0, -gap), exact, rounding(exact)) << gap;
  }
  EXPECT_NEAR(log_difference(-1000.0, -1001.0), -1000.0 + std::log(1.0 - std::exp(-1.0)), 1e-12);
  EXPECT_EQ(log_difference(3.0, 3.0), -infinity);
  EXPECT_EQ(log_difference(3.0, std::nextafter(3.0, 4.0)), -infinity) << "a rounding apart";
  EXPECT_EQ(log_difference(-infinity, -infinity), -infinity);
  EXPECT_EQ(log_difference(7.0, -infinity), 7.0);
}

TEST(LogSpace, SumAndMean) {
  EXPECT_NEAR(log_sum(std::log(2.0), std::log(3.0)), std::log(5.0), 1e-15);
  EXPECT_EQ(log_sum(-1e9, 0.0), 0.0);
  EXPECT_NEAR(log_sum(-1e9, -1e9), -1e9 + std::log(2.0), 1e-6);  // one unit in the last place
  EXPECT_EQ(log_sum(-infinity, -infinity), -infinity);
  EXPECT_EQ(log_sum(-infinity, 4.0), 4.0);
  EXPECT_NEAR(log_mean(vec({std::log(1.0), std::log(2.0), std::log(6.0)})), std::log(3.0), 1e-15);
  EXPECT_NEAR(log_mean(vec({-2000.0, -infinity})), -2000.0 - std::log(2.0), 1e-12);
  EXPECT_EQ(log_mean(vec({-infinity, -infinity})), -infinity);
  EXPECT_TRUE(std::isnan(log_mean(vec({1.0, std::nan("")}))));
}

TEST(ProbabilityWithin, AgainstLongDouble) {
  // Phi(b) - Phi(a) with the digits of long double: from erfc on the side of the smaller tail.
  const auto exact_log = [](double a, double b) {
    if (a > 0.0) {
      const double mirrored = -a;
      a = -b;
      b = mirrored;
    }
    return std::log(0.5L * (std::erfc(-b * root_half) - std::erfc(-a * root_half)));
  };
  const std::array<std::array<double, 2>, 11> limits = {{{-1, 1},
                                                         {-8, 9},
                                                         {-0.1, 0.05},
                                                         {0.5, 2},
                                                         {-30, -29},
                                                         {12, 12.5},
                                                         {-5, -4.999},
                                                         {-5.002, -5},
                                                         {3, 3.0001},
                                                         {-infinity, -20},
                                                         {-3, infinity}}};
  for (const auto& [a, b] : limits) {
    const Long exact = exact_log(a, b);
    // The thin ones lose digits of the width itself: b - a = 1e-4 is good to 4e-12.
    EXPECT_NEAR(log_probability_within(0.0, 1.0, a, b), static_cast<double>(exact),
                b - a < 0.01 ? 1e-11 : 1e-13)
        << a << " " << b;
    EXPECT_NEAR(log_probability_within(2.0, 4.0, 2.0 + 4.0 * a, 2.0 + 4.0 * b),
                static_cast<double>(exact), b - a < 0.01 ? 1e-11 : 1e-13)
        << a << " " << b;
  }
}

TEST(ProbabilityWithin, FarAndExact) {
  // Both limits far away: the nearer one decides.
  EXPECT_NEAR(log_probability_within(0.0, 1.0, 1e6, infinity) / log_normal_cdf(-1e6), 1.0, 1e-15);
  EXPECT_NEAR(log_probability_within(0.0, 1.0, 1e6, 1e6 + 1.0) / log_normal_cdf(-1e6), 1.0, 1e-15);
  EXPECT_EQ(log_probability_within(0.0, 1.0, -infinity, infinity), 0.0);
  EXPECT_EQ(log_probability_within(0.0, 1.0, 2.0, 2.0), -infinity);
  EXPECT_EQ(log_probability_within(0.0, 1.0, 2.0, 1.0), -infinity);
  EXPECT_EQ(log_probability_within(1.0, 0.0, 1.0, 2.0), 0.0);
  EXPECT_EQ(log_probability_within(2.1, 0.0, 1.0, 2.0), -infinity);
}

}  // namespace
}  // namespace parapet::acquisition
