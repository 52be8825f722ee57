// From metrics to objective and constraints: the arithmetic that every study rests on.
#include "parapet/study/scoring.hpp"

#include <gtest/gtest.h>

#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using study::Score;

const designs::Design design{{"deflector_angle_deg", 30.0}, {"upstream_height_m", 0.06}};

designs::StudySpec study_with(const std::string& objectives, const std::string& constraints) {
  Json json = tiny_study();
  json["objectives"] = Json::parse(objectives);
  json["constraints"] = Json::parse(constraints);
  return designs::parse_study(json, "test");
}

std::vector<solver::Metric> metrics(std::optional<double> launch_length) {
  return {{"retention_efficiency", 0.8, ""},
          {"launch_length_m", launch_length, launch_length ? "" : "nothing overflows"},
          {"barrier_1_slam_force_n_per_m", 150.0, ""}};
}

constexpr const char* two_objectives = R"([
  {"metric": "retention_efficiency", "goal": "maximize", "weight": 3},
  {"metric": "launch_length_m", "goal": "minimize", "weight": 2, "scale": 0.5,
   "value_when_absent": 0.1}])";

TEST(Scoring, AddsWeightedAndScaledObjectivesToBeMinimised) {
  const auto study = study_with(two_objectives, "[]");
  const Score score = study::score(study, design, metrics(0.25));
  EXPECT_DOUBLE_EQ(score.objective_scalar.value(), -3.0 * 0.8 + 2.0 * 0.25 / 0.5);
  EXPECT_FALSE(score.objectives[1].absent);
  EXPECT_TRUE(score.feasible);
}

TEST(Scoring, CountsTheSubstituteOfAnAbsentMetricAndSaysSo) {
  const auto study = study_with(two_objectives, "[]");
  const Score score = study::score(study, design, metrics({}));
  EXPECT_DOUBLE_EQ(score.objective_scalar.value(), -3.0 * 0.8 + 2.0 * 0.1 / 0.5);
  EXPECT_TRUE(score.objectives[1].absent);
  EXPECT_DOUBLE_EQ(score.objectives[1].value.value(), 0.1);
}

TEST(Scoring, HasNoScalarWithoutValueOrSubstitute) {
  auto study = study_with(two_objectives, "[]");
  study.objectives[1].value_when_absent.reset();
  const Score score = study::score(study, design, metrics({}));
  EXPECT_FALSE(score.objective_scalar.has_value());
  EXPECT_NE(score.problem.find("nothing overflows"), std::string::npos) << score.problem;
  EXPECT_FALSE(score.feasible);
}

TEST(Scoring, GivesOneScaledViolationPerLimitLowerFirst) {
  const auto study = study_with(two_objectives, R"([
    {"metric": "retention_efficiency", "lower": 0.9, "upper": 1, "scale": 0.5},
    {"name": "cheap", "expression": "upstream_height_m", "upper": 0.05},
    {"metric": "barrier_1_slam_force_n_per_m", "upper": 200}])");
  const Score score = study::score(study, design, metrics(0.25));
  ASSERT_EQ(score.metric_violations.size(), 3U);
  EXPECT_NEAR(score.metric_violations[0], (0.9 - 0.8) / 0.5, 1e-15);
  EXPECT_NEAR(score.metric_violations[1], (0.8 - 1.0) / 0.5, 1e-15);
  EXPECT_NEAR(score.metric_violations[2], (150.0 - 200.0) / 200.0, 1e-15);
  EXPECT_EQ(study::metric_limit_count(study), 3);
  EXPECT_EQ(study::expression_limit_count(study), 1);
  const auto cheap = study::expression_violations(study, design);
  ASSERT_EQ(cheap.size(), 1U);
  EXPECT_NEAR(cheap[0], (0.06 - 0.05) / 0.05, 1e-15);
  ASSERT_EQ(score.constraints.size(), 3U) << "in the spec's order";
  EXPECT_NEAR(score.constraints[0].margin.value(), -0.1, 1e-15) << "the nearer limit";
  EXPECT_FALSE(score.constraints[0].satisfied);
  EXPECT_FALSE(score.constraints[1].satisfied);
  EXPECT_TRUE(score.constraints[2].satisfied);
  EXPECT_FALSE(score.feasible);
}

TEST(Scoring, AbsentMetricSatisfiesOrViolatesAsTheSpecSays) {
  for (const bool satisfied : {true, false}) {
    const auto study =
        study_with(two_objectives, std::string(R"([{"metric": "launch_length_m", "upper": 0.4,
                                         "satisfied_when_absent": )") +
                                       (satisfied ? "true" : "false") + "}]");
    const Score score = study::score(study, design, metrics({}));
    EXPECT_EQ(score.metric_violations, std::vector<double>{satisfied ? -1.0 : 1.0});
    EXPECT_EQ(score.constraints[0].satisfied, satisfied);
    EXPECT_FALSE(score.constraints[0].value.has_value());
    EXPECT_EQ(score.feasible, satisfied);
  }
}

TEST(Scoring, ExpressionWithoutAFiniteValueIsAViolation) {
  const auto study = study_with(two_objectives, R"json([
    {"name": "ratio", "expression": "1 / (deflector_angle_deg - 30)", "upper": 1000}])json");
  EXPECT_GT(study::expression_violations(study, design).front(), 0.0);
  const designs::Design other{{"deflector_angle_deg", 31.0}, {"upstream_height_m", 0.06}};
  EXPECT_LT(study::expression_violations(study, other).front(), 0.0);
}

}  // namespace
}  // namespace parapet::test
