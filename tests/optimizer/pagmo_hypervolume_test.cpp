/// Hypervolume against an independent implementation, pagmo's. Built for the benchmarks only: users
/// do not need pagmo.
#include <gtest/gtest.h>

#include <pagmo/utils/hypervolume.hpp>

#include "front_checks.hpp"

namespace parapet::acquisition {
namespace {

TEST(PagmoHypervolume, RandomFronts) {
  SeededDraws draws(1);
  for (Eigen::Index m = 2; m <= 5; ++m) {
    for (int trial = 0; trial < 30; ++trial) {
      const auto n = static_cast<std::size_t>(1 + 2 * trial % 40);
      const auto points = trial % 3 == 0   ? random_front(draws, n, m)
                          : trial % 3 == 1 ? random_points(draws, n, m)
                                           : random_points(draws, n, m, 6);
      const Objectives reference = Objectives::Constant(m, 1.2);  // pagmo wants all points below it
      std::vector<std::vector<double>> rows;
      for (const Objectives& p : points) rows.emplace_back(p.begin(), p.end());
      const double expected =
          pagmo::hypervolume(rows).compute(std::vector<double>(reference.begin(), reference.end()));
      // Both are exact but for rounding.
      EXPECT_NEAR(hypervolume(points, reference), expected, 1e-10 * expected)
          << m << " objectives, trial " << trial;
    }
  }
}

}  // namespace
}  // namespace parapet::acquisition
