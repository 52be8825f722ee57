/// Sobol' points and the unit box.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include "parapet/optimizer/sobol.hpp"
#include "unit_box.hpp"

namespace parapet::optimizer {
namespace {

using Vector = std::vector<double>;

TEST(Sobol, BeginsAsPublished) {
  // Joe and Kuo's own program, first points in three dimensions after the corner.
  const std::array<Vector, 7> published = {{{0.5, 0.5, 0.5},
                                            {0.75, 0.25, 0.25},
                                            {0.25, 0.75, 0.75},
                                            {0.375, 0.375, 0.625},
                                            {0.875, 0.875, 0.125},
                                            {0.625, 0.125, 0.875},
                                            {0.125, 0.625, 0.375}}};
  SobolSequence sobol(3);
  for (const Vector& point : published) EXPECT_EQ(sobol.next(), point);
}

TEST(Sobol, EveryCoordinateIsStratified) {
  // 2^8 - 1 points and the corner: exactly one in each of 256 intervals, in every dimension.
  SobolSequence sobol(SobolSequence::max_dimension);
  std::vector<std::set<int>> cells(SobolSequence::max_dimension, std::set<int>{0});
  for (int k = 1; k < 256; ++k) {
    const Vector point = sobol.next();
    for (std::size_t d = 0; d < point.size(); ++d) {
      cells[d].insert(static_cast<int>(point[d] * 256.0));
    }
  }
  for (const auto& filled : cells) EXPECT_EQ(filled.size(), 256U);
}

TEST(Sobol, EveryPairOfDimensionsIsDistinct) {
  // Two equal or dependent rows of the table would put all points of a pair on few lines and leave
  // most of 16 x 16 squares empty for ever. With these rows 2^14 points fill all of them (2^12 are
  // not enough: the pair 14, 19 then still fills only half).
  SobolSequence sobol(SobolSequence::max_dimension);
  constexpr std::size_t n = SobolSequence::max_dimension;
  std::vector<std::vector<bool>> filled(n * n, std::vector<bool>(256, false));
  for (int k = 1; k < 16384; ++k) {
    const Vector p = sobol.next();
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        filled[a * n + b][16 * static_cast<std::size_t>(16 * p[a]) +
                          static_cast<std::size_t>(16 * p[b])] = true;
      }
    }
  }
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_EQ(std::count(filled[a * n + b].begin(), filled[a * n + b].end(), true), 256)
          << "dimensions " << b + 1 << ", " << a + 1;
    }
  }
}

TEST(Sobol, RefusesOtherDimensions) {
  EXPECT_THROW(SobolSequence(0), std::invalid_argument);
  EXPECT_THROW(SobolSequence(SobolSequence::max_dimension + 1), std::invalid_argument);
}

TEST(UnitBox, NeverLeavesTheBounds) {
  const Vector lower{0.1, -7.3e5, 1e-9}, upper{0.7, 1.0 / 3.0, 3.3e-9};
  const UnitBox box(lower, upper);
  EXPECT_EQ(box.from_unit({1.0, 1.0, 1.0}), upper) << "exactly, although rounding would miss it";
  EXPECT_EQ(box.from_unit({0.0, 0.0, 0.0}), lower);
  // What NLopt may return: just outside, far outside, not a number.
  EXPECT_EQ(box.from_unit({1.0 + 1e-16, 2.0, HUGE_VAL}), upper);
  EXPECT_EQ(box.from_unit({-1e-17, -3.0, std::nan("")}), lower);
}

TEST(UnitBox, GivesBackRememberedPointsToTheBit) {
  UnitBox box({0.1, -3.0}, {0.7, 5.0});
  const Vector x{0.3, 1.0 / 7.0};
  box.remember(x);
  Vector u = box.to_unit(x);
  EXPECT_EQ(box.from_unit(u), x);
  // An algorithm rebuilds its first point with errors of some ulp.
  for (double& v : u) v = std::nextafter(std::nextafter(v, 2.0), 2.0);
  EXPECT_EQ(box.from_unit(u), x);
  u[0] += 1e-11;  // ten grid steps: another point
  EXPECT_NE(box.from_unit(u), x);
}

}  // namespace
}  // namespace parapet::optimizer
