/// Sobol' indices and main effects against functions whose values are known.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "parapet/surrogate/sensitivity.hpp"

namespace parapet::surrogate {
namespace {

/// Ishigami and Homma (1990): sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1, x in [-pi, pi].
Eigen::MatrixXd ishigami(const Eigen::MatrixXd& u) {
  Eigen::MatrixXd y(u.rows(), 1);
  for (Eigen::Index i = 0; i < u.rows(); ++i) {
    const Eigen::RowVectorXd x = M_PI * (2.0 * u.row(i).array() - 1.0);
    y(i, 0) = std::sin(x(0)) * (1.0 + 0.1 * std::pow(x(2), 4)) + 7.0 * std::pow(std::sin(x(1)), 2);
  }
  return y;
}

void expect_index(const Interval& found, double truth, double tolerance, const std::string& name) {
  EXPECT_NEAR(found.value, truth, tolerance) << name;
  EXPECT_LE(found.lower, truth) << name;
  EXPECT_GE(found.upper, truth) << name;
  EXPECT_LE(found.lower, found.value) << name;
  EXPECT_GE(found.upper, found.value) << name;
}

TEST(SobolIndices, OfTheIshigamiFunction) {
  // S1 = (1 + b pi^4 / 5)^2 / 2 / V and so on with a = 7, b = 0.1.
  SensitivityOptions options;
  options.base_points = 4096;
  const auto indices = sobol_indices(ishigami, 3, options);
  const double first[] = {0.3139, 0.4424, 0.0}, total[] = {0.5576, 0.4424, 0.2437};
  for (std::size_t i = 0; i < 3; ++i) {
    // Measured 0.0007, limit 0.003; independent points would have a standard error of about
    // 1 / sqrt(4096) = 0.016.
    expect_index(indices[i].first, first[i], 0.003, "first " + std::to_string(i));
    expect_index(indices[i].total, total[i], 0.003, "total " + std::to_string(i));
    EXPECT_LT(indices[i].total.upper - indices[i].total.lower, 0.2);
  }
}

/// Indices of sum c_i u_i: c_i^2 / sum c^2, first and total alike. Up to 10 variables the points
/// are Sobol', beyond that independent. Returns how many intervals of the first indices miss.
int check_linear(const Eigen::VectorXd& c, double tolerance) {
  const auto model = [&](const Eigen::MatrixXd& u) -> Eigen::MatrixXd { return u * c; };
  const auto indices = sobol_indices(model, static_cast<int>(c.size()));
  EXPECT_EQ(indices.size(), static_cast<std::size_t>(c.size()));
  int misses = 0;
  for (Eigen::Index i = 0; i < c.size(); ++i) {
    const double truth = c(i) * c(i) / c.squaredNorm();
    const SobolIndices& found = indices[static_cast<std::size_t>(i)];
    EXPECT_NEAR(found.first.value, truth, tolerance) << i;
    EXPECT_NEAR(found.total.value, truth, tolerance) << i;
    if (found.first.lower > truth || found.first.upper < truth) ++misses;
  }
  return misses;
}

TEST(SobolIndices, OfALinearFunction) {
  // Measured 6e-5 on Sobol' points, which integrate smooth functions nearly at 1 / N; limit 1e-3.
  // The bootstrap takes the points for independent, so that its intervals are wide for them.
  EXPECT_EQ(check_linear(Eigen::Vector4d(1.0, 2.0, 3.0, 0.0), 1e-3), 0);
}

TEST(SobolIndices, OfMoreVariablesThanTheTableHolds) {
  Eigen::VectorXd c = Eigen::VectorXd::Ones(12);
  c(4) = 4.0;
  // Independent points: 1024 of them have a standard error up to about 1.5 / sqrt(1024) = 0.05 for
  // the large index; three of them.
  // Of 12 intervals of 95 % more than 3 miss with a probability of 0.2 %.
  EXPECT_LE(check_linear(c, 0.14), 3);
}

TEST(SobolIndices, SpanTheRealisations) {
  // One realisation depends on u_0 alone, the other on u_1 alone: the interval spans 0 and 1.
  const auto model = [](const Eigen::MatrixXd& u) -> Eigen::MatrixXd { return u; };
  const auto indices = sobol_indices(model, 2);
  for (const SobolIndices& index : indices) {
    EXPECT_NEAR(index.first.value, 0.5, 0.01);
    EXPECT_LT(index.first.lower, 0.02);
    EXPECT_GT(index.first.upper, 0.98);
  }
}

TEST(SobolIndices, AreZeroWhereNothingVaries) {
  const auto model = [](const Eigen::MatrixXd& u) -> Eigen::MatrixXd {
    return Eigen::MatrixXd::Constant(u.rows(), 2, 3.7);
  };
  for (const SobolIndices& index : sobol_indices(model, 3)) {
    for (const Interval& found : {index.first, index.total}) {
      EXPECT_EQ(found.value, 0.0);
      EXPECT_EQ(found.lower, 0.0);
      EXPECT_EQ(found.upper, 0.0);
    }
  }
}

TEST(SobolIndices, RepeatToTheBitAndCheckTheirArguments) {
  const auto a = sobol_indices(ishigami, 3), b = sobol_indices(ishigami, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(a[i].first.value, b[i].first.value);
    EXPECT_EQ(a[i].total.upper, b[i].total.upper);
  }
  EXPECT_THROW(sobol_indices(ishigami, 0), std::invalid_argument);
  const auto wrong = [](const Eigen::MatrixXd&) -> Eigen::MatrixXd {
    return Eigen::MatrixXd::Zero(1, 1);
  };
  EXPECT_THROW(sobol_indices(wrong, 2), std::invalid_argument);
}

TEST(MainEffects, OfAFunctionInClosedForm) {
  // y = 3 u_0 + u_1^2 and its double: effects (3 u + 1/3) and (3/2 + u^2) times 1 and 2.
  const auto model = [](const Eigen::MatrixXd& u) -> Eigen::MatrixXd {
    Eigen::MatrixXd y(u.rows(), 2);
    y.col(0) = 3.0 * u.col(0) + u.col(1).cwiseAbs2();
    y.col(1) = 2.0 * y.col(0);
    return y;
  };
  const auto effects = main_effects(model, 2, 5);
  ASSERT_EQ(effects.size(), 2U);
  for (std::size_t g = 0; g < 5; ++g) {
    const double u = 0.25 * static_cast<double>(g);
    EXPECT_EQ(effects[0].u[g], u);
    // 512 Sobol' points integrate u and u^2 to better than 2 / 512.
    const double first = 3.0 * u + 1.0 / 3.0, second = 1.5 + u * u;
    EXPECT_NEAR(effects[0].effect[g].value, 1.5 * first, 0.01);
    EXPECT_NEAR(effects[1].effect[g].value, 1.5 * second, 0.02);
    // Quantiles of two values lie 2.5 % inside them.
    EXPECT_NEAR(effects[0].effect[g].lower, 1.025 * first, 0.01);
    EXPECT_NEAR(effects[0].effect[g].upper, 1.975 * first, 0.02);
  }
}

}  // namespace
}  // namespace parapet::surrogate
