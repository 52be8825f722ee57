#include "distributions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "parapet/math/normal.hpp"

namespace parapet::designs {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double at(const Distribution& distribution, double p) {
  return quantile(distribution, p);
}

// The medians and quartiles that follow from each definition.
TEST(Quantile, FollowsTheDefinitions) {
  EXPECT_DOUBLE_EQ(at({DistributionKind::uniform, 0, 1, 2.0, 6.0}, 0.25), 3.0);
  EXPECT_DOUBLE_EQ(at({DistributionKind::normal, 5.0, 2.0, -infinity, infinity}, 0.5), 5.0);
  // The median of a lognormal quantity is mean / sqrt(1 + (sd/mean)^2).
  EXPECT_DOUBLE_EQ(at({DistributionKind::lognormal, 90.0, 27.0, 0.0, infinity}, 0.5),
                   90.0 / std::sqrt(1.0 + 0.09));
  // The share below the mode of a triangle is (mode - lower) / (upper - lower).
  const Distribution triangle{DistributionKind::triangular, 0, 1, 1.0, 5.0, 2.0};
  EXPECT_DOUBLE_EQ(at(triangle, 0.25), 2.0);
  EXPECT_DOUBLE_EQ(at(triangle, 0.0625), 1.5);        // a quarter of that share: half the way
  EXPECT_DOUBLE_EQ(at(triangle, 1.0 - 0.1875), 3.5);  // a quarter of the rest: half the way back
}

// Truncation keeps the shape between the limits and nothing beyond them.
TEST(Quantile, IsTruncated) {
  const Distribution normal{DistributionKind::normal, 10.0, 2.0, 8.0, 12.0};
  EXPECT_NEAR(kept_share(normal), 0.682689492137086, 1e-14);  // one sd on either side
  EXPECT_NEAR(at(normal, 0.5), 10.0, 1e-13);
  EXPECT_NEAR(at(normal, 1e-15), 8.0, 1e-13);
  EXPECT_NEAR(at(normal, 1.0 - 1e-15), 12.0, 1e-13);
  // The share below 9 is (Phi(-1/2) - Phi(-1)) / kept.
  EXPECT_NEAR(at(normal, (math::normal_cdf(-0.5) - math::normal_cdf(-1.0)) / kept_share(normal)),
              9.0, 1e-13);
  const Distribution half{DistributionKind::lognormal, 1.0, 1.0, 1.0 / std::sqrt(2.0), infinity};
  EXPECT_NEAR(kept_share(half), 0.5, 1e-14);  // above the median
  EXPECT_GE(at(half, 1e-12), half.lower);
}

// One point in each stratum of each dimension: that is what makes it a Latin hypercube.
TEST(LatinHypercube, FillsEveryStratumOnce) {
  constexpr std::size_t n = 37;
  const auto shares = latin_hypercube(n, 3, 5);
  ASSERT_EQ(shares.size(), 3U);
  for (const std::vector<double>& column : shares) {
    std::vector<std::size_t> strata;
    for (const double share : column) {
      EXPECT_GT(share, 0.0);
      EXPECT_LT(share, 1.0);
      strata.push_back(static_cast<std::size_t>(share * n));
    }
    EXPECT_FALSE(std::is_sorted(strata.begin(), strata.end()));
    std::sort(strata.begin(), strata.end());
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(strata[i], i);
  }
  EXPECT_NE(shares[0], shares[1]);
}

TEST(LatinHypercube, DependsOnTheSeedAlone) {
  EXPECT_EQ(latin_hypercube(8, 4, 1), latin_hypercube(8, 4, 1));
  EXPECT_NE(latin_hypercube(8, 4, 1), latin_hypercube(8, 4, 2));
}

}  // namespace
}  // namespace parapet::designs
