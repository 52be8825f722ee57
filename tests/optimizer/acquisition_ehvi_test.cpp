/// Expected hypervolume improvement: closed form against sampling and against long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "front_checks.hpp"
#include "parapet/acquisition/improvement.hpp"
#include "parapet/math/normal.hpp"

namespace parapet::acquisition {

using math::log_normal_cdf;
namespace {

/// Up to four objectives without a heap.
using Small = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;

/// What y adds: its box less what the front has of it, by inclusion and exclusion over the corners
/// of the common boxes. Values below the ideal count as the ideal.
double improvement(const std::vector<Objectives>& front, const Objectives& reference,
                   const Objectives& ideal, Small y) {
  y = y.cwiseMax(ideal);
  const double alone = (reference - y).cwiseMax(0.0).prod();
  if (alone == 0.0) return 0.0;
  double common = 0.0;
  for (std::size_t subset = 1; subset < (std::size_t{1} << front.size()); ++subset) {
    Small corner = y;
    double sign = -1.0;
    for (std::size_t i = 0; i < front.size(); ++i) {
      if (((subset >> i) & 1U) == 0) continue;
      corner = corner.cwiseMax(front[i]);
      sign = -sign;
    }
    common += sign * (reference - corner).cwiseMax(0.0).prod();
  }
  return alone - common;
}

struct Case {
  const char* name;
  std::vector<Objectives> front;
  Objectives reference, ideal, mean, sd;
};

/// A million draws; the closed form within four standard errors of their mean (one seed in 16,000
/// would miss by chance), which are themselves below 1 % of it.
void check_by_sampling(const Case& c) {
  SCOPED_TRACE(c.name);
  SeededDraws draws(7);
  constexpr int n = 1000000;
  double sum = 0.0, squares = 0.0;
  Small y(c.mean.size());
  for (int k = 0; k < n; ++k) {
    for (Eigen::Index j = 0; j < y.size(); ++j) y[j] = c.mean[j] + c.sd[j] * draws.normal();
    const double gain = improvement(c.front, c.reference, c.ideal, y);
    sum += gain;
    squares += gain * gain;
  }
  const double mean = sum / n, variance = std::max(0.0, squares / n - mean * mean);
  const double error = std::sqrt(variance / n);
  const auto boxes = undominated_boxes(c.front, c.reference, c.ideal);
  EXPECT_LT(error, 0.01 * mean);
  // Without scatter the "draws" are exact but for the rounding of their sum.
  EXPECT_NEAR(std::exp(log_ehvi(boxes, c.mean, c.sd)), mean, 4.0 * error + 1e-9 * mean);
}

const std::vector<Objectives> two = {vec({0.1, 0.8}), vec({0.4, 0.5}), vec({0.7, 0.15})};
const std::vector<Objectives> three = {vec({0.1, 0.8, 0.5}), vec({0.5, 0.4, 0.3}),
                                       vec({0.8, 0.2, 0.6}), vec({0.3, 0.7, 0.2})};
const double unknown = -infinity;

TEST(Ehvi, TwoObjectivesAgainstSampling) {
  const Objectives reference = vec({1, 1}), free = vec({unknown, unknown});
  check_by_sampling({"near the front", two, reference, free, vec({0.3, 0.4}), vec({0.2, 0.3})});
  check_by_sampling({"dominated", two, reference, free, vec({0.6, 0.7}), vec({0.15, 0.2})});
  check_by_sampling({"without a front", {}, reference, free, vec({1.1, 0.9}), vec({0.3, 0.2})});
  check_by_sampling({"wide", two, reference, free, vec({0.5, 0.5}), vec({3.0, 2.0})});
  check_by_sampling({"scales apart",
                     {vec({100, 2e-3}), vec({300, 1e-3})},
                     vec({400, 4e-3}),
                     free,
                     vec({250, 2e-3}),
                     vec({80, 1e-3})});
}

TEST(Ehvi, ThreeObjectivesAgainstSampling) {
  const Objectives reference = vec({1, 1, 1}), free = vec({unknown, unknown, unknown});
  check_by_sampling(
      {"near the front", three, reference, free, vec({0.4, 0.4, 0.4}), vec({0.2, 0.3, 0.1})});
  check_by_sampling(
      {"dominated", three, reference, free, vec({0.7, 0.6, 0.6}), vec({0.2, 0.2, 0.2})});
  check_by_sampling(
      {"without a front", {}, reference, free, vec({1.0, 0.9, 0.8}), vec({0.3, 0.3, 0.3})});
}

TEST(Ehvi, IdealBoundsAgainstSampling) {
  check_by_sampling({"both", two, vec({1, 1}), vec({0.05, 0.1}), vec({0.2, 0.3}), vec({0.3, 0.3})});
  check_by_sampling(
      {"above points", two, vec({1, 1}), vec({0.2, 0.2}), vec({0.2, 0.3}), vec({0.3, 0.3})});
  check_by_sampling(
      {"one", two, vec({1, 1}), vec({unknown, 0.0}), vec({0.0, -0.3}), vec({0.3, 0.3})});
  check_by_sampling({"three objectives", three, vec({1, 1, 1}), vec({0, 0, unknown}),
                     vec({0.1, 0.2, 0.4}), vec({0.3, 0.3, 0.2})});
}

TEST(Ehvi, ExactObjectivesAgainstSampling) {
  check_by_sampling(
      {"first", two, vec({1, 1}), vec({unknown, unknown}), vec({0.25, 0.6}), vec({0, 0.2})});
  check_by_sampling(
      {"on a point", two, vec({1, 1}), vec({unknown, unknown}), vec({0.4, 0.6}), vec({0, 0.2})});
  check_by_sampling({"both", two, vec({1, 1}), vec({unknown, 0}), vec({0.2, 0.3}), vec({0, 0})});
  check_by_sampling({"third of three", three, vec({1, 1, 1}), vec({unknown, unknown, unknown}),
                     vec({0.4, 0.5, 0.25}), vec({0.2, 0.2, 0})});
}

TEST(Ehvi, NothingToGainIsMinusInfinityOnlyWhenExact) {
  const auto boxes = undominated_boxes(two, vec({1, 1}), vec({unknown, unknown}));
  EXPECT_EQ(log_ehvi(boxes, vec({0.5, 0.6}), vec({0, 0})), -infinity);
  EXPECT_EQ(log_ehvi(boxes, vec({2.0, 0.1}), vec({0, 0.3})), -infinity);
  EXPECT_TRUE(std::isfinite(log_ehvi(boxes, vec({2.0, 0.1}), vec({1e-6, 0}))));
  EXPECT_EQ(log_ehvi({}, vec({0.5, 0.6}), vec({1, 1})), -infinity);
}

/// E[(limit - y)+] in long double; exact enough to 100 standard deviations.
long double excess(long double limit, long double mean, long double sd) {
  const long double t = (limit - mean) / sd;
  const long double density =
      std::exp(-t * t / 2.0L) / std::sqrt(2.0L * std::numbers::pi_v<long double>);
  return sd * (density + t * 0.5L * std::erfc(-t * std::sqrt(0.5L)));
}

TEST(Ehvi, FarAwayAgainstLongDouble) {
  // The staircase of `two`, box by box. Doubles underflow from 38 standard deviations on.
  for (const double far : {-3.0, 0.0, 1.0, 3.0, 10.0}) {
    for (const double sd : {0.11, 0.5, 30.0}) {
      const Objectives mean = vec({0.4 + far, 0.3 + far});
      const auto e = [&](int j, double limit) { return excess(limit, mean[j], sd); };
      const long double exact = e(0, 0.1) * e(1, 1.0) + (e(0, 0.4) - e(0, 0.1)) * e(1, 0.8) +
                                (e(0, 0.7) - e(0, 0.4)) * e(1, 0.5) +
                                (e(0, 1.0) - e(0, 0.7)) * e(1, 0.15);
      const auto boxes = undominated_boxes(two, vec({1, 1}), vec({unknown, unknown}));
      const auto expected = static_cast<double>(std::log(exact));
      // Some roundings of logarithms that reach 8000; t^2 loses most of the digits of t = 90.
      EXPECT_NEAR(log_ehvi(boxes, mean, vec({sd, sd})), expected,
                  1e-13 + 1e-15 * std::abs(expected))
          << far << " " << sd;
    }
  }
}

TEST(Ehvi, ThinBoxesKeepTheirDigits) {
  // One box, thinner and thinner, in standard deviations.
  const auto value = [](double t, double width) {
    const auto boxes = undominated_boxes({}, vec({t + width}), vec({t}));
    return log_ehvi(boxes, vec({0}), vec({1}));
  };
  for (const double t : {-6.0, -3.0, -1.5, -0.5, 0.0, 0.7, 2.0}) {
    for (const double width : {0.5, 0.05, 2.1e-3, 1e-3, 9e-5}) {
      const double upper = t + width;
      const auto exact = static_cast<double>(std::log(excess(upper, 0, 1) - excess(t, 0, 1)));
      // The rule's own 1e-14; long double's difference is good to t^4 5e-20 / (width t) = 1e-13
      // here (at -20 no longer). The second-order term, t^2 width^2 / 24, is 1e-8 at -6.
      EXPECT_NEAR(value(t, width), exact, 5e-13 + 4e-16 * std::abs(exact)) << t << " " << width;
    }
    // So thin that only the first order is left: the probability to lie below times the width.
    for (const double width : {0x1p-30, 0x1p-40}) {
      EXPECT_NEAR(value(t, width), std::log(width) + log_normal_cdf(t), 1e-13 + 21.0 * width) << t;
    }
  }
}

TEST(Ehvi, RisesWhenAMeanFallsFarBeyondUnderflow) {
  for (const auto& [front, m] : {std::pair{two, 2}, std::pair{three, 3}}) {
    const auto boxes =
        undominated_boxes(front, Objectives::Ones(m), Objectives::Constant(m, unknown));
    for (Eigen::Index j = 0; j < m; ++j) {
      double before = -infinity;
      for (double mean = 1e7; mean > 1e-3; mean *= 0.9) {
        Objectives means = Objectives::Constant(m, 0.5);
        means[j] = mean;
        const double gain = log_ehvi(boxes, means, Objectives::Constant(m, 0.1));
        EXPECT_GT(gain, before) << mean;
        before = gain;
      }
    }
  }
}

TEST(Ehvi, OneObjectiveIsExpectedImprovement) {
  const std::vector<Objectives> front = {vec({0.7}), vec({0.4}), vec({0.9})};
  const auto boxes = undominated_boxes(front, vec({1}), vec({unknown}));
  ASSERT_EQ(boxes.size(), 1U);
  for (const double mean : {-3.0, 0.0, 0.39, 0.4, 0.6, 2.0, 6.0, 1e4}) {
    for (const double sd : {0.0, 0.1, 2.0}) {
      EXPECT_EQ(log_ehvi(boxes, vec({mean}), vec({sd})), log_expected_excess(0.4 - mean, sd));
    }
  }
  // And that is what Jones, Schonlau and Welch (1998) define.
  EXPECT_NEAR(std::exp(log_ehvi(boxes, vec({0.6}), vec({0.3}))),
              static_cast<double>(excess(0.4L, 0.6L, 0.3L)), 1e-15);
}

}  // namespace
}  // namespace parapet::acquisition
