/// Probability of success.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "parapet/surrogate/success_model.hpp"
#include "probit_laplace.hpp"
#include "surrogate_cases.hpp"

namespace parapet::surrogate {
namespace {

/// Success where x_0 < 0.7: 30 % of the square fails.
std::vector<bool> left_of_seven_tenths(const Eigen::MatrixXd& x) {
  std::vector<bool> succeeded;
  for (Eigen::Index i = 0; i < x.rows(); ++i) succeeded.push_back(x(i, 0) < 0.7);
  return succeeded;
}

TEST(SuccessModel, RecoversAHalfSpace) {
  const Eigen::MatrixXd x = unit_points(80, 2, 1);
  const auto model = SuccessModel::fit(plain_layout(2), x, left_of_seven_tenths(x));
  EXPECT_TRUE(model.any_failure());
  const Eigen::MatrixXd at = unit_points(400, 2, 2);
  const Eigen::VectorXd p = model.log_probability(at).array().exp();
  for (Eigen::Index i = 0; i < 400; ++i) {
    // 80 points leave gaps of about 1 / sqrt(80) = 0.11 beside the boundary.
    if (at(i, 0) < 0.7 - 0.11) {
      EXPECT_GT(p(i), 0.5) << at.row(i);
    }
    if (at(i, 0) > 0.7 + 0.11) {
      EXPECT_LT(p(i), 0.5) << at.row(i);
    }
    if (at(i, 0) < 0.35) {
      EXPECT_GT(p(i), 0.9) << at.row(i);
    }
  }
}

TEST(SuccessModel, WithoutFailureIsCertain) {
  const auto model =
      SuccessModel::fit(plain_layout(2), unit_points(9, 2, 1), std::vector<bool>(9, true));
  EXPECT_FALSE(model.any_failure());
  EXPECT_EQ(model.log_probability(unit_points(5, 2, 2)), Eigen::VectorXd::Zero(5));
  const auto empty = SuccessModel::fit(plain_layout(2), Eigen::MatrixXd(0, 2), {});
  EXPECT_EQ(empty.log_probability(unit_points(5, 2, 2)), Eigen::VectorXd::Zero(5));
}

TEST(SuccessModel, FarFromAllDataIsTheBaseRate) {
  const Eigen::MatrixXd x = unit_points(20, 2, 1);
  std::vector<bool> succeeded(20, true);
  succeeded[3] = succeeded[8] = false;
  const auto model = SuccessModel::fit(plain_layout(2), x, succeeded);
  // Matern's tail at 1e4 length scales is 0: (18 + 1/2) / (20 + 1).
  EXPECT_NEAR(std::exp(model.log_probability(Eigen::RowVector2d(1e6, 1e6))(0)), 18.5 / 21.0, 1e-12);
}

TEST(SuccessModel, OneFailureWarnsOnlyNearby) {
  for (const int d : {1, 3, 6}) {
    Eigen::MatrixXd x = unit_points(20, d, 1);
    x.row(0).setConstant(0.05);
    std::vector<bool> succeeded(20, true);
    succeeded[0] = false;
    const auto model = SuccessModel::fit(plain_layout(d), x, succeeded);
    const double at_failure = std::exp(model.log_probability(x.row(0))(0));
    const double far = std::exp(model.log_probability(Eigen::RowVectorXd::Constant(d, 0.9))(0));
    // The base rate is 0.93, successes around raise it, and nothing far may pull it to 0.5.
    EXPECT_GT(far, 0.9) << d;
    EXPECT_LT(at_failure, far - 0.05) << d;
  }
}

TEST(SuccessModel, OnlyFailuresAreFiniteAndUnlikely) {
  const Eigen::MatrixXd x = unit_points(12, 2, 1);
  const auto model = SuccessModel::fit(plain_layout(2), x, std::vector<bool>(12, false));
  const Eigen::VectorXd log_p = model.log_probability(unit_points(50, 2, 3));
  EXPECT_TRUE(log_p.allFinite());
  EXPECT_LT(log_p.maxCoeff(), std::log(0.2));
}

TEST(SuccessModel, StandsRepeatedInputsWithBothOutcomes) {
  const auto model =
      SuccessModel::fit(plain_layout(1), column({0.5, 0.5, 0.5, 0.5}), {true, false, true, false});
  EXPECT_NEAR(std::exp(model.log_probability(column({0.5}))(0)), 0.5, 1e-6);  // by symmetry
}

TEST(SuccessModel, IsTheSameToTheBitEachTimeAndChecksShapes) {
  const Eigen::MatrixXd x = unit_points(40, 2, 1);
  const auto a = SuccessModel::fit(plain_layout(2), x, left_of_seven_tenths(x));
  const auto b = SuccessModel::fit(plain_layout(2), x, left_of_seven_tenths(x));
  EXPECT_EQ(a.log_probability(unit_points(5, 2, 2)), b.log_probability(unit_points(5, 2, 2)));
  EXPECT_THROW(SuccessModel::fit(plain_layout(2), x, {true}), std::invalid_argument);
  EXPECT_THROW(a.log_probability(column({0.5})), std::invalid_argument);
}

TEST(ProbitLaplace, ModeIsStationary) {
  const Eigen::MatrixXd x = unit_points(30, 2, 1);
  const Eigen::MatrixXd k = 4.0 * matern({0, 1}, Eigen::Vector2d(0.3, 0.5), x, x);
  Eigen::VectorXd signs(30);
  for (Eigen::Index i = 0; i < 30; ++i) signs(i) = x(i, 0) < 0.7 ? 1.0 : -1.0;
  const LaplaceMode mode = find_mode(k, signs, 0.3);
  // Newton stops when the objective gains 1e-12: the latent values are then exact to about 1e-6.
  const Eigen::VectorXd right = (k * mode.gradient).array() + 0.3;
  EXPECT_LT((mode.latent - right).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(ProbitLaplace, EvidenceOfOneOutcome) {
  // Exactly Phi(mean / sqrt(1 + variance)); Laplace's error for a probit at variance 1 is below 5
  // %.
  const LaplaceMode mode = find_mode(Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Ones(1), 0.4);
  EXPECT_NEAR(mode.log_evidence, math::log_normal_cdf(0.4 / std::sqrt(2.0)), 0.05);
}

TEST(ProbitLaplace, GradientEqualsCentralDifferences) {
  const Layout layout{{0, 1, 1}, 1};
  const Eigen::MatrixXd x = unit_points(25, 3, 1);
  Eigen::VectorXd signs(25);
  for (Eigen::Index i = 0; i < 25; ++i) signs(i) = x(i, 0) + 0.3 * x(i, 1) < 0.8 ? 1.0 : -1.0;
  const ProbitEvidence evidence(layout, x, signs);
  ASSERT_EQ(evidence.size(), 3);
  const Eigen::VectorXd at = evidence.centre() + Eigen::Vector3d(0.2, -0.3, 0.4);
  Eigen::VectorXd gradient, unused;
  evidence.evaluate(at, gradient);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double h = 1e-4;
    Eigen::VectorXd up = at, down = at;
    up(i) += h;
    down(i) -= h;
    const double slope =
        (evidence.evaluate(up, unused) - evidence.evaluate(down, unused)) / (2.0 * h);
    // The mode's own error, up to 1e-6 in the latent values, moves the determinant by about 1e-7:
    // 1e-3 of slope at worst.
    EXPECT_NEAR(gradient(i), slope, 1e-3) << i;
  }
}

}  // namespace
}  // namespace parapet::surrogate
