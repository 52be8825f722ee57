// What one more run would give: by hand from runs, surrogates and spacings.
#include "parapet/study/repeat.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace parapet::study {
namespace {

constexpr double t_2 = 4.302652729749462;  // 97.5 % of Student's t with 2 degrees of freedom
constexpr double t_4 = 2.776445105197793;  // with 4

TEST(Repeat, ThreeRunsAloneGiveStudentsPredictionInterval) {
  const auto estimate = repeat_estimate({.own = 0.90, .again = {0.92, 0.88}}).value();
  EXPECT_NEAR(estimate.mean, 0.90, 1e-15);
  EXPECT_NEAR(estimate.scatter.value(), 0.02, 1e-15);
  // The textbook's mean ± t s sqrt(1 + 1/n); the quantile is good to 1e-12.
  const double half = t_2 * 0.02 * std::sqrt(1.0 + 1.0 / 3.0);
  EXPECT_NEAR(estimate.lower_95().value(), 0.90 - half, 1e-11);
  EXPECT_NEAR(estimate.upper_95().value(), 0.90 + half, 1e-11);
  EXPECT_FALSE(estimate.grid.has_value()) << "one spacing tells nothing of the grid";
  EXPECT_EQ(estimate.grid_source, GridSource::none);
}

TEST(Repeat, OneRunKnowsNoUncertainty) {
  const auto estimate = repeat_estimate({.own = 0.9}).value();
  EXPECT_EQ(estimate.mean, 0.9);
  EXPECT_FALSE(estimate.lower_95().has_value());
  EXPECT_FALSE(estimate.probability_within({}, 1.0).has_value());
  EXPECT_FALSE(repeat_estimate({}).has_value());
}

// The quickstart once recommended 0.0987 m against a limit of 0.1 m with "100 %".
TEST(Repeat, ALaunchBesideItsLimitIsNotCertain) {
  const auto estimate =
      repeat_estimate({.own = 0.0987, .again = {0.0820, 0.0990}, .least = 0.0}).value();
  const double probability = estimate.probability_within({}, 0.1).value();
  // Mean 0.0932, s.d. 0.0097, prediction s.d. 0.0112: t = 0.60 with 2 degrees of freedom is 0.70.
  EXPECT_NEAR(probability, 0.70, 0.01);
}

TEST(Repeat, LaterRunsAndTheSurrogateShareByTheirPrecision) {
  // Equal doubt: surrogate's s.d. 0.01; two runs of s.d. 0.01 sqrt 2 each.
  RepeatEvidence evidence;
  evidence.surrogate = SurrogateBelief{
      .mean = 0.5, .deviation = 0.01, .noise = 0.01 * std::sqrt(2.0), .noise_freedom = 1e9};
  evidence.own = 0.9;  // its luck counts through the surrogate alone
  evidence.again = {0.52, 0.56};
  const auto estimate = repeat_estimate(evidence).value();
  // 1e9 degrees of freedom leave the noise as it is to 1e-9.
  EXPECT_NEAR(estimate.mean, 0.5 + 0.5 * 0.04, 1e-8);
  EXPECT_NEAR(estimate.mean_uncertainty, 0.01 / std::sqrt(2.0), 1e-8);
}

TEST(Repeat, MeasuredScatterPoolsWithTheSurrogatesNoise) {
  RepeatEvidence evidence;
  evidence.surrogate =
      SurrogateBelief{.mean = 0.9, .deviation = 0.0, .noise = 0.001, .noise_freedom = 2.0};
  evidence.own = 0.90;
  evidence.again = {0.9045, 0.8955};
  const auto estimate = repeat_estimate(evidence).value();
  // 2 x 0.001^2 and 2 x 0.0045^2 over 4 degrees of freedom: not 0.001 beside a measured 0.0045.
  const double scatter = std::sqrt((2.0 * 0.001 * 0.001 + 2.0 * 0.0045 * 0.0045) / 4.0);
  EXPECT_NEAR(estimate.scatter.value(), scatter, 1e-15);
  EXPECT_NEAR(estimate.upper_95().value() - estimate.mean, t_4 * scatter, 1e-12);
}

TEST(Repeat, IntervalsHoldOnlyWhatCanBe) {
  const auto length = repeat_estimate({.own = 0.0, .again = {0.0, 0.0257}, .least = 0.0}).value();
  EXPECT_EQ(length.lower_95().value(), 0.0);
  EXPECT_GT(length.upper_95().value(), 0.0257);
  const auto share =
      repeat_estimate({.own = 1.0, .again = {0.99, 0.995}, .least = 0.0, .greatest = 1.0}).value();
  EXPECT_EQ(share.upper_95().value(), 1.0);
  EXPECT_EQ(share.probability_within({}, 1.0), 1.0) << "no share is above 1";
  EXPECT_EQ(length.probability_within(0.0, {}), 1.0) << "no length is below 0";
}

TEST(Repeat, GridUncertaintyIsTheDifferenceBetweenSpacings) {
  RepeatEvidence evidence{.own = 0.90, .again = {0.92, 0.88}, .finer = 0.86};
  const auto run = repeat_estimate(evidence).value();
  EXPECT_NEAR(run.grid.value(), 0.04, 1e-15);
  EXPECT_EQ(run.grid_source, GridSource::other_run);
  EXPECT_NEAR(run.standard_uncertainty().value(),
              std::sqrt(0.02 * 0.02 * (1.0 + 1.0 / 3.0) + 0.04 * 0.04), 1e-15);
  // Welch-Satterthwaite: 2 (u^2 / u_runs^2)^2.
  const double runs = 0.02 * 0.02 * (4.0 / 3.0), all = runs + 0.04 * 0.04;
  EXPECT_NEAR(run.freedom, 2.0 * (all / runs) * (all / runs), 1e-9);
  evidence.finer.reset();
  evidence.surrogate = SurrogateBelief{
      .mean = 0.9, .deviation = 0.0, .noise = 0.01, .noise_freedom = 9.0, .grid = 0.03};
  const auto levels = repeat_estimate(evidence).value();
  EXPECT_EQ(levels.grid, 0.03);
  EXPECT_EQ(levels.grid_source, GridSource::levels);
}

TEST(Repeat, APredictionKnowsNoLaterRun) {
  RepeatEvidence evidence;
  EXPECT_FALSE(prediction(evidence).has_value());
  evidence.surrogate = SurrogateBelief{.mean = 0.9, .deviation = 0.003, .noise = 0.004};
  evidence.again = {0.5};
  evidence.finer = 0.4;
  const auto predicted = prediction(evidence).value();
  EXPECT_EQ(predicted.mean, 0.9);
  EXPECT_NEAR(predicted.standard_uncertainty().value(), 0.005, 1e-15);
}

TEST(Repeat, AFormulaIsExact) {
  const RepeatEstimate exact = exact_estimate(0.1876);
  EXPECT_EQ(exact.lower_95(), 0.1876);
  EXPECT_EQ(exact.upper_95(), 0.1876);
  EXPECT_EQ(exact.probability_within({}, 0.1876), 1.0);
  EXPECT_EQ(exact.probability_within({}, 0.1875), 0.0);
}

}  // namespace
}  // namespace parapet::study
