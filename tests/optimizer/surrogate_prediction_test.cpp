/// Predictions of a Gaussian process whose parameters are given.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "surrogate_cases.hpp"

namespace parapet::surrogate {
namespace {

/// Matern 5/2 at distance d for length l, written out again.
double correlation(double d, double l) {
  const double r = std::sqrt(5.0) * std::abs(d) / l;
  return (1.0 + r + r * r / 3.0) * std::exp(-r);
}

constexpr double rounding = 1e-13;  // a handful of operations on numbers near 1

TEST(Prediction, OneObservationByHand) {
  // amplitude 2, noise 0.3, mean 1, y(0.3) = 2: k = 4 M(0.4 / 0.5).
  const Data data{column({0.3}), column({2.0}), {}};
  const auto process = GaussianProcess::fit(
      plain_layout(1), data, with_parameters({level_parameters({0.5}, 2.0, 0.3, 1.0)}));
  const double k = 4.0 * correlation(0.4, 0.5);
  const Prediction at = process.predict(column({0.7}));
  EXPECT_NEAR(at.mean(0), 1.0 + k / 4.09 * (2.0 - 1.0), rounding);
  EXPECT_NEAR(at.variance(0), 4.0 - k * k / 4.09, rounding);
  EXPECT_NEAR(process.log_likelihood(),
              -0.5 / 4.09 - 0.5 * std::log(4.09) - 0.5 * std::log(2.0 * M_PI), rounding);
}

TEST(Prediction, TwoObservationsByHand) {
  // K + noise = [[d, c], [c, d]], its inverse [[d, -c], [-c, d]] / (d^2 - c^2).
  const Data data{column({0.2, 0.6}), column({1.0, -1.0}), {}};
  const auto process = GaussianProcess::fit(
      plain_layout(1), data, with_parameters({level_parameters({0.4}, 1.5, 0.2, 0.5)}));
  const double a2 = 2.25, d = a2 + 0.04, c = a2 * correlation(0.4, 0.4), det = d * d - c * c;
  const double k1 = a2 * correlation(0.3, 0.4), k2 = a2 * correlation(0.1, 0.4);
  const double r1 = 0.5, r2 = -1.5;
  const Prediction at = process.predict(column({0.5}));
  EXPECT_NEAR(at.mean(0), 0.5 + (k1 * (d * r1 - c * r2) + k2 * (d * r2 - c * r1)) / det, rounding);
  EXPECT_NEAR(at.variance(0), a2 - (d * k1 * k1 - 2.0 * c * k1 * k2 + d * k2 * k2) / det, rounding);
  EXPECT_NEAR(process.log_likelihood(),
              -0.5 * (d * r1 * r1 - 2.0 * c * r1 * r2 + d * r2 * r2) / det - 0.5 * std::log(det) -
                  std::log(2.0 * M_PI),
              rounding);
}

TEST(Prediction, ColumnsOfAGroupShareALength) {
  // Columns 0 and 2 with length 0.5, column 1 with length 2.
  const Layout layout{{0, 1, 0}, 1};
  const Data data{Eigen::RowVector3d(0.1, 0.2, 0.3), column({1.0}), {}};
  const auto process = GaussianProcess::fit(
      layout, data, with_parameters({level_parameters({0.5, 2.0}, 1.0, 0.1, 0.0)}));
  const Eigen::RowVector3d x(0.4, 0.9, 0.5);
  const double distance = std::sqrt((0.09 + 0.04) / 0.25 + 0.49 / 4.0);
  EXPECT_NEAR(process.predict(x).mean(0), correlation(distance, 1.0) / 1.01, rounding);
}

TEST(Prediction, JointAgreesWithIndependent) {
  const Layout layout = plain_layout(2);
  const LevelParameters level = level_parameters({0.3, 0.6}, 1.2, 0.1, 0.4);
  const Eigen::MatrixXd x = unit_points(25, 2, 1), at = unit_points(9, 2, 2);
  const Data data{x, draw_process(layout, level, x, 3), {}};
  const auto process = GaussianProcess::fit(layout, data, with_parameters({level}));
  const JointPrediction joint = process.joint(at);
  const Prediction single = process.predict(at);
  EXPECT_LT((joint.mean - single.mean).cwiseAbs().maxCoeff(), rounding);
  // Differences of numbers near 1.44 that passed a solve of condition 25 * 1.44 / 0.01.
  EXPECT_LT((joint.covariance.diagonal() - single.variance).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(joint.covariance, joint.covariance.transpose());
}

TEST(Prediction, InterpolatesWhereTheNoiseIsTiny) {
  const Eigen::MatrixXd x = unit_points(20, 1, 5);
  Eigen::VectorXd y(20);
  for (Eigen::Index i = 0; i < 20; ++i) y(i) = 300.0 + 50.0 * std::sin(6.0 * x(i, 0));
  FitOptions options;
  options.known_noise = {0.0};
  const auto process = GaussianProcess::fit(plain_layout(1), {x, y, {}}, options);
  const Prediction at = process.predict(x);
  for (Eigen::Index i = 0; i < 20; ++i) {
    // The least noise of the model is 1e-4 of the output's s.d., here about 35.
    EXPECT_NEAR(process.from_model(at.mean(i)), y(i), 3e-4 * 35.0);
    EXPECT_LT(at.variance(i), 1e-7);
  }
  // Between the observations, 0.05 apart: measured 0.05 of an amplitude of 50, limit 0.15.
  for (double t = 0.02; t < 0.98; t += 0.01) {
    EXPECT_NEAR(process.from_model(process.predict(column({t})).mean(0)),
                300.0 + 50.0 * std::sin(6.0 * t), 0.15)
        << t;
  }
}

TEST(LeaveOneOut, EqualsRefittingWithoutTheObservation) {
  const Layout layout = plain_layout(2, 2);
  const std::vector<LevelParameters> levels = {level_parameters({0.5, 0.5}, 0.5, 0.1, 0.2, 0.9),
                                               level_parameters({0.4, 0.8}, 1.0, 0.2, -0.1)};
  Data data{unit_points(18, 2, 4), normals(18, 5), {}};
  for (int i = 0; i < 18; ++i) data.levels.push_back(i % 3 == 0 ? 0 : 1);
  const FitOptions options = with_parameters(levels);
  const auto all = GaussianProcess::fit(layout, data, options);
  const LeaveOneOut left_out = all.leave_one_out();
  double squared = 0.0;
  int covered = 0;
  for (Eigen::Index i = 0; i < 18; ++i) {
    std::vector<Eigen::Index> others;
    Data rest;
    for (Eigen::Index j = 0; j < 18; ++j) {
      if (j == i) continue;
      others.push_back(j);
      rest.levels.push_back(data.levels[static_cast<std::size_t>(j)]);
    }
    rest.inputs = data.inputs(others, Eigen::all);
    rest.values = data.values(others);
    const int level = data.levels[static_cast<std::size_t>(i)];
    const auto process = GaussianProcess::fit(layout, rest, options);
    const Prediction at = process.predict(data.inputs.row(i), level);
    const double noise = process.noise(level);
    const double deviation = std::sqrt(at.variance(0) + noise * noise);
    // Two solves of condition about 18 * 1.8 / 0.01 apart.
    EXPECT_NEAR(left_out.mean(i), at.mean(0), 1e-11);
    EXPECT_NEAR(left_out.residual(i), (data.values(i) - at.mean(0)) / deviation, 1e-10);
    EXPECT_NEAR(left_out.upper(i), at.mean(0) + 1.959963984540054 * deviation, 1e-10);
    EXPECT_NEAR(left_out.lower(i), at.mean(0) - 1.959963984540054 * deviation, 1e-10);
    squared += std::pow(data.values(i) - at.mean(0), 2);
    if (data.values(i) >= left_out.lower(i) && data.values(i) <= left_out.upper(i)) ++covered;
  }
  const double spread = (data.values.array() - data.values.mean()).square().sum();
  EXPECT_NEAR(left_out.q_squared, 1.0 - squared / spread, 1e-10);
  EXPECT_NEAR(left_out.coverage_95, covered / 18.0, 1e-15);
}

TEST(GaussianProcess, ManyObservationsAllPredictButAPartDecidesTheParameters) {
  const Layout layout = plain_layout(1);
  constexpr Eigen::Index n = 300;
  const Eigen::MatrixXd x = unit_points(n, 1, 3);
  Data all{x, (6.0 * x.col(0).array()).sin().matrix() + 0.2 * normals(n, 4), {}};
  Data half;  // more than 150: every second decides
  half.inputs = x(Eigen::seq(0, n - 1, 2), Eigen::all);
  half.values = all.values(Eigen::seq(0, n - 1, 2));
  FitOptions options;
  options.transform = TransformKind::identity;
  const GaussianProcess process = GaussianProcess::fit(layout, all, options);
  const GaussianProcess part = GaussianProcess::fit(layout, half, options);
  EXPECT_EQ(process.data().values.size(), n);
  // Values are standardised with all data in one and with half in the other: 1 % apart at most.
  const LevelParameters &a = process.parameters().levels[0], &b = part.parameters().levels[0];
  EXPECT_NEAR(a.length_scales(0), b.length_scales(0), 0.05 * b.length_scales(0));
  EXPECT_NEAR(a.noise, b.noise, 0.05 * b.noise);
  // Twice the observations: about half the variance, far from it with a part alone.
  const Eigen::MatrixXd at = column({0.2, 0.5, 0.8});
  const Eigen::VectorXd ratio =
      process.predict(at).variance.cwiseQuotient(part.predict(at).variance);
  EXPECT_GT(ratio.minCoeff(), 0.4);
  EXPECT_LT(ratio.maxCoeff(), 0.7);
}

std::string message_of(const Layout& layout, const Data& data, const FitOptions& options) {
  try {
    GaussianProcess::fit(layout, data, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(GaussianProcess, SaysWhatIsWrongWithItsArguments) {
  const Data good{column({0.1, 0.5}), column({1.0, 2.0}), {}};
  EXPECT_EQ(message_of(plain_layout(1), {column({0.1}), column({1.0, 2.0}), {}}, {}),
            "Gaussian process: 1 rows of inputs for 2 values");
  EXPECT_EQ(message_of(plain_layout(2), good, {}),
            "Gaussian process: 1 columns of inputs for a layout of 2");
  EXPECT_EQ(message_of(plain_layout(1), {column({0.1}), column({NAN}), {}}, {}),
            "Gaussian process: a value is not finite");
  EXPECT_EQ(message_of(plain_layout(1), {column({0.1}), column({1.0}), {1}}, {}),
            "Gaussian process: level 1 is outside 0 .. 0");
  FitOptions options;
  options.keep_parameters = true;
  EXPECT_EQ(message_of(plain_layout(1), good, options),
            "Gaussian process: keep_parameters asks for a warm_start, and there is none");
  options = with_parameters({level_parameters({0.5, 0.5}, 1.0, 0.1, 0.0)});
  EXPECT_EQ(message_of(plain_layout(1), good, options),
            "Gaussian process: warm_start has 2 length scales, the layout 1 groups");
  EXPECT_THROW(GaussianProcess::fit(plain_layout(1), good, {}).predict(Eigen::MatrixXd(1, 2)),
               std::invalid_argument);
}

}  // namespace
}  // namespace parapet::surrogate
