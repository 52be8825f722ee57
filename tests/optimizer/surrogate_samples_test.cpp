/// Joint draws of a process, and predictions given them.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "surrogate_cases.hpp"

namespace parapet::surrogate {
namespace {

GaussianProcess noisy_process() {
  const LevelParameters level = level_parameters({0.3, 0.6}, 1.2, 0.3, 0.4);
  const Eigen::MatrixXd x = unit_points(20, 2, 1);
  return GaussianProcess::fit(plain_layout(2), {x, normals(20, 3), {}}, with_parameters({level}));
}

TEST(PosteriorSamples, HaveTheMomentsOfTheJointPrediction) {
  const GaussianProcess process = noisy_process();
  // Three inputs are drawn from Sobol' points alone, twenty-five also from independent ones.
  for (const int p : {3, 25}) {
    const Eigen::MatrixXd at = unit_points(p, 2, 9);
    const int n = 4096;
    const Eigen::MatrixXd draws = PosteriorSamples(process, at, n, 5).values();
    const JointPrediction joint = process.joint(at);
    ASSERT_EQ(draws.rows(), n);
    const Eigen::RowVectorXd mean = draws.colwise().mean();
    const Eigen::MatrixXd centred = draws.rowwise() - mean;
    const Eigen::MatrixXd covariance = centred.transpose() * centred / n;
    for (int i = 0; i < p; ++i) {
      const double vi = joint.covariance(i, i);
      // Five standard errors of n independent draws.
      EXPECT_NEAR(mean(i), joint.mean(i), 5.0 * std::sqrt(vi / n));
      for (int j = 0; j <= i; ++j) {
        const double cij = joint.covariance(i, j);
        const double error = std::sqrt((vi * joint.covariance(j, j) + cij * cij) / n);
        EXPECT_NEAR(covariance(i, j), cij, 5.0 * error) << i << " " << j;
      }
    }
  }
}

TEST(PosteriorSamples, PredictLikeAProcessThatSawTheDraws) {
  // One process over 20 noisy observations and 4 noise-free ones, its matrix inverted as a whole.
  const GaussianProcess process = noisy_process();
  const LevelParameters& level = process.parameters().levels[0];
  const Eigen::MatrixXd at = unit_points(4, 2, 11), x = unit_points(6, 2, 12);
  const PosteriorSamples samples(process, at, 5, 3);
  Eigen::MatrixXd mean;
  Eigen::VectorXd variance;
  samples.predict(x, mean, variance);
  Eigen::MatrixXd all(24, 2);
  all << process.data().inputs, at;
  const double a2 = level.amplitude * level.amplitude;
  Eigen::MatrixXd k = a2 * matern({0, 1}, level.length_scales, all, all);
  k.diagonal().head(20).array() += level.noise * level.noise;
  const Eigen::MatrixXd inverse = k.inverse();
  const Eigen::MatrixXd cross = a2 * matern({0, 1}, level.length_scales, all, x);
  Eigen::VectorXd y(24);
  for (Eigen::Index s = 0; s < 5; ++s) {
    y << process.data().values, samples.values().row(s).transpose();
    const Eigen::VectorXd expected =
        (cross.transpose() * inverse * (y.array() - level.mean).matrix()).array() + level.mean;
    // Condition of the matrix about 1e3.
    EXPECT_LT((mean.row(s).transpose() - expected).cwiseAbs().maxCoeff(), 1e-10);
  }
  const Eigen::VectorXd expected = a2 - (cross.transpose() * inverse * cross).diagonal().array();
  EXPECT_LT((variance - expected).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(PosteriorSamples, PredictTheDrawsThemselvesAtTheirInputs) {
  const GaussianProcess process = noisy_process();
  const Eigen::MatrixXd at = unit_points(6, 2, 11);
  const PosteriorSamples samples(process, at, 7, 3);
  Eigen::MatrixXd mean;
  Eigen::VectorXd variance;
  samples.predict(at, mean, variance);
  EXPECT_LT((mean - samples.values()).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(variance.maxCoeff(), 1e-9);
  EXPECT_GE(variance.minCoeff(), 0.0);
}

TEST(PosteriorSamples, WithoutInputsPredictAsTheProcessDoes) {
  const GaussianProcess process = noisy_process();
  const PosteriorSamples samples(process, Eigen::MatrixXd(0, 2), 3, 1);
  EXPECT_EQ(samples.values().rows(), 3);
  EXPECT_EQ(samples.values().cols(), 0);
  const Eigen::MatrixXd x = unit_points(5, 2, 12);
  Eigen::MatrixXd mean;
  Eigen::VectorXd variance;
  samples.predict(x, mean, variance);
  const Prediction plain = process.predict(x);
  ASSERT_EQ(mean.rows(), 3);
  for (Eigen::Index s = 0; s < 3; ++s) EXPECT_EQ(mean.row(s).transpose(), plain.mean);
  EXPECT_EQ(variance, plain.variance);
}

TEST(PosteriorSamples, StandRepeatedInputsAndRepeat) {
  const GaussianProcess process = noisy_process();
  Eigen::MatrixXd at(4, 2);
  at << 0.2, 0.3, 0.2, 0.3, 0.2, 0.3 + 1e-13, 0.9, 0.9;
  const PosteriorSamples a(process, at, 64, 3), b(process, at, 64, 3), c(process, at, 64, 4);
  EXPECT_EQ(a.values(), b.values());
  EXPECT_NE(a.values(), c.values());
  // Draws at equal inputs are equal but for the jitter, at most 1e-10 of a variance near 1.
  EXPECT_LT((a.values().col(0) - a.values().col(1)).cwiseAbs().maxCoeff(), 1e-4);
  Eigen::MatrixXd mean;
  Eigen::VectorXd variance;
  a.predict(unit_points(30, 2, 2), mean, variance);
  EXPECT_TRUE(mean.allFinite());
  EXPECT_GE(variance.minCoeff(), 0.0);
  EXPECT_THROW(PosteriorSamples(process, at, 0, 3), std::invalid_argument);
}

}  // namespace
}  // namespace parapet::surrogate
