/// Several levels of fidelity in one process.
#include <gtest/gtest.h>

#include <cmath>

#include "surrogate_cases.hpp"

namespace parapet::surrogate {
namespace {

constexpr double rounding = 1e-12;

/// Forrester, Sobester and Keane (Proc. R. Soc. A 463 (2007) 3251-3269), equation (4.1).
double forrester(double x) {
  return std::pow(6.0 * x - 2.0, 2) * std::sin(12.0 * x - 4.0);
}
double cheap_forrester(double x) {
  return 0.5 * forrester(x) + 10.0 * (x - 0.5) - 5.0;
}

TEST(Levels, OneCoarseObservationByHand) {
  // cov(f_0(x), f_1(x')) = rho a_1^2 M; y(0.3) = 2 at level 1.
  const std::vector<LevelParameters> levels = {level_parameters({0.2}, 0.6, 0.1, 0.5, 1.3),
                                               level_parameters({0.5}, 1.1, 0.3, -0.2)};
  const auto process = GaussianProcess::fit(plain_layout(1, 2), {column({0.3}), column({2.0}), {1}},
                                            with_parameters(levels));
  const double r = std::sqrt(5.0) * 0.4 / 0.5;
  const double m = (1.0 + r + r * r / 3.0) * std::exp(-r);
  const double a2 = 1.21, observed = a2 + 0.09, k = 1.3 * a2 * m;
  const Prediction fine = process.predict(column({0.7}), 0);
  EXPECT_NEAR(fine.mean(0), 0.5 + k / observed * 2.2, rounding);
  EXPECT_NEAR(fine.variance(0), 1.69 * a2 + 0.36 - k * k / observed, rounding);
  const Prediction coarse = process.predict(column({0.7}), 1);
  EXPECT_NEAR(coarse.mean(0), -0.2 + a2 * m / observed * 2.2, rounding);
  const double coarse_variance = a2 - a2 * m * a2 * m / observed;
  EXPECT_NEAR(coarse.variance(0), coarse_variance, rounding);
  const double cross = 1.3 * a2 - k * a2 * m / observed;
  EXPECT_NEAR(process.covariance(column({0.7}), 0, column({0.7}), 1)(0, 0), cross, rounding);
  EXPECT_NEAR(process.correlation_squared(column({0.7}), 1)(0),
              cross * cross / (fine.variance(0) * coarse_variance), rounding);
  EXPECT_EQ(process.correlation_squared(column({0.7}), 0)(0), 1.0);
}

TEST(Levels, ThreeLevelsMultiplyTheirCouplings) {
  // Without data: cov(f_0, f_2) = rho_0 rho_1 a_2^2, var f_0 = sum of all three parts.
  const std::vector<LevelParameters> levels = {level_parameters({0.2}, 0.5, 0.1, 0.0, 1.5),
                                               level_parameters({0.3}, 0.7, 0.1, 0.0, 0.8),
                                               level_parameters({0.4}, 1.1, 0.1, 0.0)};
  const Data none{Eigen::MatrixXd(0, 1), Eigen::VectorXd(0), {}};
  const auto process = GaussianProcess::fit(plain_layout(1, 3), none, with_parameters(levels));
  const Eigen::MatrixXd x = column({0.5});
  EXPECT_NEAR(process.covariance(x, 0, x, 2)(0, 0), 1.5 * 0.8 * 1.21, rounding);
  EXPECT_NEAR(process.covariance(x, 1, x, 2)(0, 0), 0.8 * 1.21, rounding);
  EXPECT_NEAR(process.covariance(x, 2, x, 1)(0, 0), 0.8 * 1.21, rounding);
  EXPECT_NEAR(process.predict(x, 0).variance(0), 0.25 + 2.25 * 0.49 + 1.44 * 1.21, rounding);
}

TEST(Levels, UncoupledLevelsAreSeparateProcesses) {
  const Eigen::MatrixXd x = unit_points(24, 2, 1), at = unit_points(7, 2, 2);
  const Eigen::VectorXd y = normals(24, 3);
  const std::vector<LevelParameters> levels = {level_parameters({0.2, 0.4}, 0.6, 0.2, 0.5, 0.0),
                                               level_parameters({0.5, 0.3}, 1.1, 0.3, -0.2)};
  Data both{x, y, {}};
  std::vector<Eigen::Index> rows[2];
  for (Eigen::Index i = 0; i < 24; ++i) {
    both.levels.push_back(i % 3 == 0 ? 0 : 1);
    rows[both.levels.back()].push_back(i);
  }
  const auto joint = GaussianProcess::fit(plain_layout(2, 2), both, with_parameters(levels));
  for (int level = 0; level < 2; ++level) {
    const Data own{x(rows[level], Eigen::all), y(rows[level]), {}};
    const auto plain = GaussianProcess::fit(
        plain_layout(2), own, with_parameters({levels[static_cast<std::size_t>(level)]}));
    const Prediction a = joint.predict(at, level), b = plain.predict(at);
    EXPECT_LT((a.mean - b.mean).cwiseAbs().maxCoeff(), rounding);
    EXPECT_LT((a.variance - b.variance).cwiseAbs().maxCoeff(), rounding);
  }
  EXPECT_LT(joint.correlation_squared(at, 1).maxCoeff(), 1e-20);
}

double error_of(const GaussianProcess& process) {
  double sum = 0.0;
  for (int i = 0; i < 101; ++i) {
    const double x = 0.01 * i;
    const double mean = process.predict(column({x})).mean(0);
    sum += std::pow(process.from_model(mean) - forrester(x), 2) / 101.0;
  }
  return std::sqrt(sum);
}

TEST(Levels, CoarseDataImproveTheFinePrediction) {
  Data fine{column({0.0, 0.4, 0.6, 1.0}), Eigen::VectorXd(4), {0, 0, 0, 0}};
  for (Eigen::Index i = 0; i < 4; ++i) fine.values(i) = forrester(fine.inputs(i, 0));
  Data both = fine;
  both.inputs.conservativeResize(15, 1);
  both.values.conservativeResize(15);
  for (int i = 0; i < 11; ++i) {
    both.inputs(4 + i, 0) = 0.1 * i;
    both.values(4 + i) = cheap_forrester(0.1 * i);
    both.levels.push_back(1);
  }
  FitOptions options;
  options.transform = TransformKind::identity;
  options.known_noise = {0.0, 0.0};
  const auto joint = GaussianProcess::fit(plain_layout(1, 2), both, options);
  options.known_noise = {0.0};
  const auto alone = GaussianProcess::fit(plain_layout(1), fine, options);
  // Four points miss the minimum of a function that spans -6 to 16; eleven cheap ones show it.
  EXPECT_GT(error_of(alone), 2.0);
  EXPECT_LT(error_of(joint), 0.5 * error_of(alone));
}

TEST(Levels, RecoversTheCoupling) {
  // A draw of the model itself: 40 fine and 100 coarse observations.
  const Layout layout = plain_layout(2, 2);
  const std::vector<LevelParameters> truth = {level_parameters({0.5, 0.5}, 0.1, 0.05, 0.3, 0.6),
                                              level_parameters({0.3, 0.3}, 1.0, 0.05, 0.0)};
  Data data{unit_points(140, 2, 21), Eigen::VectorXd(140), {}};
  for (int i = 0; i < 140; ++i) data.levels.push_back(i % 7 < 2 ? 0 : 1);
  Eigen::MatrixXd k(140, 140);
  for (Eigen::Index i = 0; i < 140; ++i) {
    const int level = data.levels[static_cast<std::size_t>(i)];
    k.col(i) = prior_covariance(layout, truth, data.inputs, data.levels, data.inputs.row(i), level);
    k(i, i) += 0.0025;
  }
  const Eigen::MatrixXd factor = k.llt().matrixL();
  data.values = factor * normals(140, 22);
  for (Eigen::Index i = 0; i < 140; ++i) {
    if (data.levels[static_cast<std::size_t>(i)] == 0) data.values(i) += 0.3;
  }
  FitOptions options;
  options.transform = TransformKind::identity;
  const auto process = GaussianProcess::fit(layout, data, options);
  // rho is a regression of f_0 on f_1: s.d. about 0.1 / 1 over the square root of some 4 to 10
  // independent patches of the difference, 0.05; three of them.
  EXPECT_NEAR(process.parameters().levels[0].coupling, 0.6, 0.15);
}

TEST(Levels, AnEmptyLevelTakesThePrior) {
  // Only coarse data: the fine level follows them, with more variance.
  const Eigen::MatrixXd x = unit_points(15, 1, 2);
  Eigen::VectorXd y(15);
  for (Eigen::Index i = 0; i < 15; ++i) y(i) = std::sin(5.0 * x(i, 0));
  const auto process =
      GaussianProcess::fit(plain_layout(1, 3), {x, y, std::vector<int>(15, 2)}, {});
  const Prediction fine = process.predict(x, 0), coarse = process.predict(x, 2);
  EXPECT_NEAR(process.parameters().levels[0].coupling, 1.0, 1e-3);  // the prior's centre
  EXPECT_NEAR(process.parameters().levels[0].mean, process.parameters().levels[2].mean, 1e-12);
  EXPECT_LT((fine.mean - coarse.mean).cwiseAbs().maxCoeff(), 1e-2);
  EXPECT_GT((fine.variance - coarse.variance).minCoeff(), 0.1);
  // Only fine data, none at the coarsest.
  const auto other = GaussianProcess::fit(plain_layout(1, 2), {x, y, {}}, {});
  EXPECT_NEAR(other.from_model(other.predict(column({0.5})).mean(0)), std::sin(2.5), 0.05);
  EXPECT_TRUE(other.predict(x, 1).mean.allFinite());
}

}  // namespace
}  // namespace parapet::surrogate
