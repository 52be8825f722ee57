// Discretisation error against cases with a known answer, and the uncertainty of a whole result.
#include "parapet/solver/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace parapet::solver {
namespace {

TEST(DiscretisationError, FindsTheOrderAndTheLimitOfAPowerLaw) {
  for (const double order : {0.7, 1.0, 1.5, 2.0}) {
    const std::vector<double> h{0.005, 0.007, 0.010};
    std::vector<double> values;
    for (const double spacing : h) values.push_back(3.0 - 0.4 * std::pow(spacing / 0.005, order));
    const DiscretisationError error = discretisation_error(h, values);
    EXPECT_TRUE(error.order_observed);
    EXPECT_NEAR(error.order, order, 0.011);  // the scan's step is 0.01
    EXPECT_NEAR(error.extrapolated, 3.0, 0.02);
    EXPECT_NEAR(error.coefficient, -0.4, 0.02);
    EXPECT_NEAR(error.deviation, 0.0, 1e-3);
    EXPECT_NEAR(error.uncertainty, 1.25 * 0.4, 0.03);  // Roache's factor for an observed order
  }
}

TEST(DiscretisationError, TakesAFactorOfThreeWhereValuesDoNotConverge) {
  // up and down; by hand, the second order fits better than the first: slope -4/545 over h^2
  const std::vector<double> h{1.0, 1.5, 2.0}, values{1.0, 1.2, 1.0};
  const DiscretisationError error = discretisation_error(h, values);
  EXPECT_FALSE(error.order_observed);
  EXPECT_EQ(error.order, 2.0);
  const double limit = 16.0 / 15.0 + 29.0 / 1635.0, fit = limit - 4.0 / 545.0;
  EXPECT_NEAR(error.extrapolated, limit, 1e-12);
  const double deviation = std::sqrt(2.0 / 75.0 - 2.0 / 8175.0);  // one degree of freedom
  EXPECT_NEAR(error.uncertainty, 3.0 * (limit - 1.0) + deviation + (fit - 1.0), 1e-12);
}

TEST(DiscretisationError, IsZeroForEqualValuesAndNeedsThree) {
  const std::vector<double> h{1.0, 2.0, 4.0}, same{7.0, 7.0, 7.0};
  EXPECT_EQ(discretisation_error(h, same).uncertainty, 0.0);
  EXPECT_EQ(discretisation_error(h, same).extrapolated, 7.0);
  const std::vector<double> two{1.0, 2.0};
  EXPECT_THROW(discretisation_error(two, two), std::invalid_argument);
}

Scene small_scene() {
  Scene scene;
  scene.barriers = {Barrier{}};
  return scene;
}

TEST(Uncertainty, LeavesTheResultAsItIsAndDoesNotDependOnTheJobs) {
  Numerics numerics;
  numerics.spacing = 0.02;
  RunOptions options;
  options.stop_time = 0.6;
  UncertaintyPlan plan;
  const Result plain = simulate(small_scene(), numerics, options);
  const Result one = simulate_with_uncertainty(small_scene(), numerics, options, plan);
  plan.jobs = 3;
  const Result three = simulate_with_uncertainty(small_scene(), numerics, options, plan);
  ASSERT_EQ(one.metrics.size(), plain.metrics.size());
  int with = 0;
  for (std::size_t k = 0; k < plain.metrics.size(); ++k) {
    EXPECT_EQ(one.metrics[k].value, plain.metrics[k].value) << plain.metrics[k].key;
    ASSERT_EQ(one.metrics[k].uncertainty.has_value(), three.metrics[k].uncertainty.has_value());
    if (!one.metrics[k].uncertainty) continue;
    ++with;
    EXPECT_EQ(one.metrics[k].uncertainty->expanded, three.metrics[k].uncertainty->expanded);
    EXPECT_EQ(one.metrics[k].uncertainty->runs, 9);
  }
  EXPECT_GT(one.find_metric("barrier_1_slam_force_n_per_m")->uncertainty->scatter, 0.0);
  EXPECT_GT(with, 5);
}

TEST(Uncertainty, CanBeCancelledAndRefusesPlansThatTellNothing) {
  Numerics numerics;
  numerics.spacing = 0.02;
  RunOptions options;
  options.stop_time = 0.6;
  const Result cancelled = simulate_with_uncertainty(small_scene(), numerics, options, {},
                                                     [](double done) { return done < 0.1; });
  EXPECT_EQ(cancelled.status, Status::cancelled);
  UncertaintyPlan plan;
  plan.levels = {{1.0, 1}, {1.4, 1}, {2.0, 1}};  // no repeats
  EXPECT_THROW(simulate_with_uncertainty(small_scene(), numerics, options, plan),
               std::invalid_argument);
  plan.levels = {{1.0, 2}, {2.0, 2}};
  EXPECT_THROW(simulate_with_uncertainty(small_scene(), numerics, options, plan),
               std::invalid_argument);
}

}  // namespace
}  // namespace parapet::solver
