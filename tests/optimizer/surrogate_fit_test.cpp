/// Parameters of a Gaussian process from data.
#include <gtest/gtest.h>

#include <cmath>

#include "marginal_likelihood.hpp"
#include "surrogate_cases.hpp"

namespace parapet::surrogate {
namespace {

TEST(MarginalLikelihood, GradientEqualsCentralDifferences) {
  // Three levels, four columns in three groups, levels in no order.
  const Layout layout{{0, 1, 1, 2}, 3};
  const Eigen::MatrixXd x = unit_points(30, 4, 1);
  const Eigen::VectorXd z = normals(30, 2);
  std::vector<int> levels;
  for (int i = 0; i < 30; ++i) levels.push_back((7 * i) % 3);
  const ParameterVector vector(3, 3);
  const Priors priors = make_priors(vector, {});
  const MarginalLikelihood likelihood(layout, x, z, levels, priors);
  Eigen::VectorXd at = priors.centre + 0.3 * normals(vector.size(), 3);
  at(vector.coupling(2)) = 0.0;
  Eigen::VectorXd gradient, unused;
  likelihood.evaluate(at, gradient);
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    const double h = 1e-5;
    Eigen::VectorXd up = at, down = at;
    up(i) += h;
    down(i) -= h;
    const double slope =
        (likelihood.evaluate(up, unused) - likelihood.evaluate(down, unused)) / (2.0 * h);
    // Values of some hundreds at a condition of 1e4: 1e-10 of rounding over 1e-5, and h^2.
    EXPECT_NEAR(gradient(i), slope, 1e-5 * (1.0 + std::abs(slope))) << "parameter " << i;
  }
}

TEST(MarginalLikelihood, AgreesWithTheProcessItFits) {
  const Layout layout = plain_layout(2, 2);
  const std::vector<LevelParameters> levels = {level_parameters({0.5, 0.3}, 0.5, 0.1, 0.0, 0.7),
                                               level_parameters({0.4, 0.8}, 1.0, 0.2, 0.0)};
  Data data{unit_points(20, 2, 4), normals(20, 5), {}};
  for (int i = 0; i < 20; ++i) data.levels.push_back(i % 2);
  const ParameterVector vector(2, 2);
  const Priors priors = make_priors(vector, {});
  const MarginalLikelihood likelihood(layout, data.inputs, data.values, data.levels, priors);
  const Eigen::VectorXd x = vector.pack(levels);
  Eigen::VectorXd gradient(x.size());
  const double posterior = likelihood.evaluate(x, gradient);
  // The same value from the process: its means are 0 here, so move those of the likelihood out by
  // asking for the likelihood at the means that it found.
  std::vector<LevelParameters> with_means = levels;
  Eigen::MatrixXd k(20, 20);
  for (Eigen::Index i = 0; i < 20; ++i) {
    const int level = data.levels[static_cast<std::size_t>(i)];
    k.col(i) =
        prior_covariance(layout, levels, data.inputs, data.levels, data.inputs.row(i), level);
    const double noise = levels[static_cast<std::size_t>(level)].noise;
    k(i, i) += noise * noise;
  }
  const Eigen::VectorXd means =
      best_means(k.inverse(), data.values, data.levels, priors.mean_precision);
  with_means[0].mean = means(0);
  with_means[1].mean = means(1);
  const auto process = GaussianProcess::fit(layout, data, with_parameters(with_means));
  gradient.setZero();
  EXPECT_NEAR(posterior,
              process.log_likelihood() - 0.5 * means.dot(priors.mean_precision * means) +
                  priors.log_density(x, gradient),
              1e-9);  // sums of some tens at a condition of 1e4
}

TEST(Fit, RecoversNoiseAndTheOrderOfLengthScales) {
  const Layout layout = plain_layout(2);
  const LevelParameters truth = level_parameters({0.2, 1.0}, 3.0, 0.5, 10.0);
  const Eigen::MatrixXd x = unit_points(200, 2, 11);
  const Eigen::VectorXd y = draw_process(layout, truth, x, 12) + 0.5 * normals(200, 13);
  FitOptions options;
  options.transform = TransformKind::identity;
  const auto process = GaussianProcess::fit(layout, {x, y, {}}, options);
  const LevelParameters& found = process.parameters().levels[0];
  const double scale = process.parameters().transform.scale;
  // About 150 degrees of freedom are left for the noise: relative s.d. 1 / sqrt(2 * 150) = 6 %;
  // four of them are 24 %.
  EXPECT_NEAR(found.noise * scale, 0.5, 0.24 * 0.5);
  EXPECT_LT(2.0 * found.length_scales(0), found.length_scales(1));
  // One draw holds about 1 / (0.2 * 1) = 5 independent patches: a factor of 2 either way.
  EXPECT_GT(found.length_scales(0), 0.1);
  EXPECT_LT(found.length_scales(0), 0.4);
}

TEST(Fit, KeepsToAKnownNoise) {
  const Eigen::MatrixXd x = unit_points(40, 1, 3);
  Eigen::VectorXd y(40);
  for (Eigen::Index i = 0; i < 40; ++i) y(i) = 100.0 * std::sin(5.0 * x(i, 0));
  FitOptions options;
  options.transform = TransformKind::identity;
  options.known_noise = {20.0};
  const auto process = GaussianProcess::fit(plain_layout(1), {x, y, {}}, options);
  // Free of noise, the data pull down with up to 40 nats per unit of log noise, the prior of s.d.
  // 0.1 gives 100 per unit squared: at most 0.4 in the logarithm.
  const double noise = process.noise() * process.parameters().transform.scale;
  EXPECT_GT(noise, 20.0 * std::exp(-0.4));
  EXPECT_LT(noise, 20.0 * std::exp(0.4));
}

TEST(Fit, ChoosesTheTransformThatTheDataAskFor) {
  const Eigen::MatrixXd x = unit_points(40, 2, 9);
  Eigen::VectorXd decades(40), linear(40), both_signs(40);
  for (Eigen::Index i = 0; i < 40; ++i) {
    const double t = 6.0 * x(i, 0) - 3.0 + x(i, 1);
    decades(i) = std::exp(1.5 * t);
    linear(i) = t;
    both_signs(i) = std::sinh(2.0 * t);
  }
  const Layout layout = plain_layout(2);
  const auto kind = [&](const Eigen::VectorXd& y) {
    return GaussianProcess::fit(layout, {x, y, {}}, {}).parameters().transform.kind;
  };
  EXPECT_EQ(kind(decades), TransformKind::log);
  EXPECT_EQ(kind(linear), TransformKind::identity);
  EXPECT_EQ(kind(both_signs), TransformKind::bilog);
}

TEST(Fit, AWarmStartKeepsTheKindAndMeasuresAgain) {
  const Eigen::MatrixXd x = unit_points(40, 1, 9);
  Eigen::VectorXd y(40);
  for (Eigen::Index i = 0; i < 40; ++i) y(i) = std::exp(6.0 * x(i, 0));
  const auto first = GaussianProcess::fit(plain_layout(1), {x, y, {}}, {});
  ASSERT_EQ(first.parameters().transform.kind, TransformKind::log);
  FitOptions options;
  options.starts = 1;
  options.warm_start = first.parameters();
  const auto again = GaussianProcess::fit(plain_layout(1), {x, 1e3 * y, {}}, options);
  EXPECT_EQ(again.parameters().transform.kind, TransformKind::log);
  EXPECT_NEAR(again.parameters().transform.shift,
              first.parameters().transform.shift + std::log(1e3), 1e-12);
  // The same values in model units, started at the maximum: no worse than before.
  EXPECT_GE(again.log_likelihood(), first.log_likelihood() - 0.1);
  options.keep_parameters = true;
  const auto kept = GaussianProcess::fit(plain_layout(1), {x, 1e3 * y, {}}, options);
  EXPECT_EQ(kept.parameters().transform.shift, first.parameters().transform.shift);
  EXPECT_EQ(kept.parameters().levels[0].mean, first.parameters().levels[0].mean);
}

/// Predicts something finite everywhere, with a variance that is not negative.
void expect_sound(const Data& data, const std::string& name) {
  const Layout layout = plain_layout(static_cast<int>(data.inputs.cols()));
  const auto process = GaussianProcess::fit(layout, data, {});
  const Prediction at = process.predict(unit_points(50, static_cast<int>(data.inputs.cols()), 1));
  EXPECT_TRUE(at.mean.allFinite()) << name;
  EXPECT_TRUE(at.variance.allFinite()) << name;
  EXPECT_GE(at.variance.minCoeff(), 0.0) << name;
  EXPECT_TRUE(process.joint(data.inputs).covariance.allFinite()) << name;
  EXPECT_TRUE(process.leave_one_out().residual.allFinite()) << name;
}

TEST(Fit, IllConditionedDataGiveASoundProcess) {
  expect_sound({Eigen::MatrixXd(0, 1), Eigen::VectorXd(0), {}}, "no data");
  expect_sound({column({0.5}), column({1e6}), {}}, "one point");
  expect_sound({column({0.5, 0.5 + 1e-12}), column({1.0, 2.0}), {}}, "two points 1e-12 apart");
  expect_sound({column({0.5, 0.5, 0.5}), column({1.0, 2.0, 3.0}), {}}, "repeated input");
  expect_sound({column({0.5, 0.5, 0.5}), column({2.0, 2.0, 2.0}), {}}, "repeated observation");
  expect_sound({unit_points(30, 2, 1), Eigen::VectorXd::Constant(30, -4.0), {}}, "equal values");
  expect_sound(
      {unit_points(30, 1, 1), Eigen::VectorXd::Constant(30, 0.1) + 1e-18 * normals(30, 1), {}},
      "values equal but for rounding");
  Eigen::VectorXd step = Eigen::VectorXd::Zero(30);
  step(7) = 1e12;
  expect_sound({unit_points(30, 3, 1), step, {}}, "one far value");
  Eigen::MatrixXd clustered = unit_points(60, 2, 2);
  clustered.topRows(30) *= 1e-9;
  expect_sound({clustered, normals(60, 3), {}}, "half the inputs within 1e-9");
  FitOptions options;
  options.known_noise = {0.0};
  const auto process = GaussianProcess::fit(
      plain_layout(1), {column({0.2, 0.2, 0.2 + 1e-12}), column({1.0, 2.0, 3.0}), {}}, options);
  EXPECT_TRUE(process.predict(column({0.2})).mean.allFinite());
}

TEST(Fit, RepeatedInputsGiveTheirMean) {
  // Ten observations at each of two places: the mean of each, within s.d. / sqrt(10) of it.
  Eigen::MatrixXd x(20, 1);
  x.topRows(10).setConstant(0.2);
  x.bottomRows(10).setConstant(0.8);
  Eigen::VectorXd y = 0.3 * normals(20, 4);
  y.tail(10).array() += 5.0;
  const auto process = GaussianProcess::fit(plain_layout(1), {x, y, {}}, {});
  const Prediction at = process.predict(column({0.2, 0.8}));
  EXPECT_NEAR(process.from_model(at.mean(0)), y.head(10).mean(), 0.3 / std::sqrt(10.0));
  EXPECT_NEAR(process.from_model(at.mean(1)), y.tail(10).mean(), 0.3 / std::sqrt(10.0));
}

TEST(Fit, IsTheSameToTheBitEachTime) {
  const Eigen::MatrixXd x = unit_points(50, 3, 6);
  const Data data{x, normals(50, 7), {}};
  const auto a = GaussianProcess::fit(plain_layout(3), data, {});
  const auto b = GaussianProcess::fit(plain_layout(3), data, {});
  EXPECT_EQ(a.parameters().levels[0].length_scales, b.parameters().levels[0].length_scales);
  EXPECT_EQ(a.log_likelihood(), b.log_likelihood());
  const Eigen::MatrixXd at = unit_points(9, 3, 8);
  EXPECT_EQ(a.predict(at).mean, b.predict(at).mean);
  EXPECT_EQ(a.predict(at).variance, b.predict(at).variance);
}

}  // namespace
}  // namespace parapet::surrogate
