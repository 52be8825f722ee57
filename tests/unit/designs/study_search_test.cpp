// Goals, fidelity levels and the options of the search.
#include <gtest/gtest.h>

#include "study_fixture.hpp"
#include "wrong_input.hpp"

namespace parapet::designs {
namespace {

/// Every part in use that sound_study leaves at its default.
Json full_study() {
  Json json = sound_study();
  json["objectives"] = Json::parse(R"([
      {"metric": "retention_efficiency", "statistic": "quantile", "quantile": 0.75, "reference": 0.4},
      {"metric": "launch_length_m", "goal": "minimize", "value_when_absent": 0, "statistic": "worst"},
      {"name": "safe", "metric": "barrier_2_slam_force_n_per_m", "statistic": "probability",
       "upper": 300},
      {"name": "plate", "expression": "upstream_height_m + plate_m", "goal": "minimize"}])");
  json["constraints"] = Json::parse(R"([
      {"metric": "retention_efficiency_total", "lower": 0.95, "statistic": "probability",
       "quantile": 0.75},
      {"metric": "launch_length_m", "upper": 0.3, "value_when_absent": 0.1, "statistic": "mean"}])");
  json["fidelity"] = Json::parse(R"({"spacings_m": [0.02, 0.008, 0.01],
      "noise": {"retention_efficiency": [0.02, 0.004, 0.006]}, "cpu_time_s": [0.3, 10, 1.2]})");
  json["method"] = Json::parse(R"({"algorithm": "BAYESIAN", "max_cpu_time_s": 3600,
      "scalarization": "augmented_chebyshev", "pareto_points": 7, "points_per_variable": 4,
      "stagnation_evaluations": 12, "least_gain": 0.01, "repeatable": true})");
  return json;
}

TEST(StudySearch, ValuesReachTheirFields) {
  const StudySpec study = parse_study(full_study(), "s");
  ASSERT_EQ(study.objectives.size(), 4U);
  EXPECT_EQ(study.objectives[0].name, "retention_efficiency");
  EXPECT_EQ(study.objectives[0].statistic, Statistic::quantile);
  EXPECT_EQ(study.objectives[0].quantile, 0.75);
  EXPECT_EQ(study.objectives[0].reference, 0.4);
  EXPECT_EQ(study.objectives[1].statistic, Statistic::worst);
  EXPECT_EQ(study.objectives[2].name, "safe");
  EXPECT_EQ(study.objectives[2].statistic, Statistic::probability);
  EXPECT_EQ(study.objectives[2].upper, 300.0);
  EXPECT_FALSE(study.objectives[2].lower);
  EXPECT_EQ(study.objectives[3].metric, "");
  EXPECT_EQ(study.objectives[3].expression, "upstream_height_m + plate_m");
  EXPECT_EQ(study.constraints[0].statistic, Statistic::probability);
  EXPECT_EQ(study.constraints[0].quantile, 0.75);
  EXPECT_EQ(study.constraints[1].statistic, Statistic::mean);
  EXPECT_EQ(study.constraints[1].value_when_absent, 0.1);

  ASSERT_EQ(study.fidelity.size(), 3U);  // finest first
  EXPECT_EQ(study.fidelity[0].spacing, 0.008);
  EXPECT_EQ(study.fidelity[0].seconds, 10.0);
  EXPECT_EQ(study.fidelity[0].noise.at("retention_efficiency"), 0.004);
  EXPECT_EQ(study.fidelity[2].spacing, 0.02);
  EXPECT_EQ(study.fidelity[2].seconds, 0.3);
  EXPECT_EQ(study.fidelity[2].noise.at("retention_efficiency"), 0.02);

  EXPECT_EQ(study.method.max_cpu_time_s, 3600.0);
  EXPECT_EQ(study.method.scalarization, Scalarization::augmented_chebyshev);
  EXPECT_EQ(study.method.pareto_points, 7);
  EXPECT_EQ(study.method.points_per_variable, 4);
  EXPECT_EQ(study.method.stagnation_evaluations, 12);
  EXPECT_EQ(study.method.least_gain, 0.01);
  EXPECT_TRUE(study.method.repeatable);
}

TEST(StudySearch, ResolvedReadsBackTheSame) {
  const StudySpec study = parse_study(full_study(), "s");
  const StudySpec again = parse_study(Json::parse(study.resolved.dump()), "s");
  EXPECT_EQ(study.resolved.dump(), again.resolved.dump());
}

// The schema's defaults are the structs' own, and without levels the case's spacing is the level.
TEST(StudySearch, Defaults) {
  Json json = sound_study();
  json["method"] = Json::object();
  const StudySpec study = parse_study(json, "s");
  const Method expected;
  EXPECT_EQ(study.method.algorithm, expected.algorithm);
  EXPECT_EQ(study.method.max_cpu_time_s, expected.max_cpu_time_s);
  EXPECT_EQ(study.method.scalarization, expected.scalarization);
  EXPECT_EQ(study.method.pareto_points, expected.pareto_points);
  EXPECT_EQ(study.method.points_per_variable, expected.points_per_variable);
  EXPECT_EQ(study.method.stagnation_evaluations, expected.stagnation_evaluations);
  EXPECT_EQ(study.method.least_gain, expected.least_gain);
  EXPECT_EQ(study.method.repeatable, expected.repeatable);
  EXPECT_EQ(study.objectives[0].statistic, Objective{}.statistic);
  EXPECT_EQ(study.objectives[0].quantile, Objective{}.quantile);
  EXPECT_EQ(study.constraints[0].statistic, Constraint{}.statistic);
  EXPECT_EQ(study.constraints[0].quantile, Constraint{}.quantile);
  EXPECT_TRUE(study.scenarios.empty());
  ASSERT_EQ(study.fidelity.size(), 1U);
  EXPECT_EQ(study.fidelity[0].spacing, 0.01);
  EXPECT_FALSE(study.fidelity[0].seconds);
  EXPECT_TRUE(study.fidelity[0].noise.empty());
}

// The finest level takes the place of the case's spacing, and the resolved case says so.
TEST(StudySearch, TheFinestLevelIsTheCases) {
  const StudySpec study = parse_study(full_study(), "s");
  EXPECT_EQ(study.base_case["numerics"]["spacing_m"], 0.008);
  EXPECT_EQ(study.resolved["case"]["numerics"]["spacing_m"], 0.008);
  EXPECT_EQ(design_case(study, {}).numerics.spacing, 0.008);
  EXPECT_EQ(design_case(study, {}, nullptr, 0.02).numerics.spacing, 0.02);
}

const WrongInput wrong_searches[] = {
    {"ObjectiveOfNothing", R"([{"op": "remove", "path": "/objectives/0/metric"}])", "/objectives/0",
     "asks for nothing", "either a metric or an expression"},
    {"ObjectiveOfTwoThings",
     R"([{"op": "add", "path": "/objectives/0/expression", "value": "plate_m"}])", "/objectives/0",
     "asks for two things", "either a metric or an expression"},
    {"ExpressionWithAStatistic",
     R"([{"op": "add", "path": "/objectives/3/statistic", "value": "worst"}])",
     "/objectives/3/statistic", "an expression is the same in every event", "no statistic"},
    {"ExpressionThatIsAbsent",
     R"([{"op": "add", "path": "/objectives/3/value_when_absent", "value": 0}])",
     "/objectives/3/value_when_absent", "an expression has a value always", "no such value"},
    {"ExpressionCutOff",
     R"([{"op": "replace", "path": "/objectives/3/expression", "value": "plate_m *"}])",
     "/objectives/3/expression", "cannot be read", "a formula of"},
    {"NameTwice", R"([{"op": "replace", "path": "/objectives/3/name", "value": "safe"}])",
     "/objectives/3/name", "another objective is called \"safe\" too", "a name of its own"},
    {"StatisticUnknown",
     R"([{"op": "replace", "path": "/objectives/1/statistic", "value": "wurst"}])",
     "/objectives/1/statistic", "did you mean \"worst\"?", "\"mean\", \"worst\""},
    {"QuantileTooLarge", R"([{"op": "replace", "path": "/objectives/0/quantile", "value": 90}])",
     "/objectives/0/quantile", "is too large", "a number above 0 up to 1"},
    {"ProbabilityOfNothing", R"([{"op": "remove", "path": "/objectives/2/upper"}])",
     "/objectives/2", "has no limit", "lower, upper or both"},
    {"ProbabilityLimitsSwapped", R"([{"op": "add", "path": "/objectives/2/lower", "value": 400}])",
     "/objectives/2", "lower limit is above its upper", "lower <= upper"},
    {"LimitWithoutProbability", R"([{"op": "add", "path": "/objectives/1/upper", "value": 1}])",
     "/objectives/1/upper", "has no use without the statistic probability",
     "the statistic \"probability\", or a constraint"},
    {"ConstraintOnAnExpressionWithAStatistic",
     R"([{"op": "add", "path": "/constraints/0",
          "value": {"expression": "plate_m", "upper": 1, "statistic": "mean"}}])",
     "/constraints/0/statistic", "an expression is the same in every event", "no statistic"},
    {"SpacingTwice", R"([{"op": "replace", "path": "/fidelity/spacings_m/0", "value": 0.01}])",
     "/fidelity/spacings_m", "holds 0.01 twice", "each spacing once"},
    {"SpacingTooCoarse", R"([{"op": "replace", "path": "/fidelity/spacings_m/0", "value": 0.08}])",
     "/fidelity/spacings_m", "0.08 is not possible: /case/numerics/spacing_m is too coarse",
     "at most 0.05 [m]"},
    {"NoSpacings", R"([{"op": "replace", "path": "/fidelity/spacings_m", "value": []}])",
     "/fidelity/spacings_m", "has 0 entries", "a list of 1 to 10 entries"},
    {"NoiseOfNoMetric",
     R"([{"op": "add", "path": "/fidelity/noise/retention", "value": [1, 2, 3]}])",
     "/fidelity/noise/retention", "is not a metric of this case", "retention_efficiency"},
    {"NoiseOfSomeLevels", R"([{"op": "remove", "path": "/fidelity/noise/retention_efficiency/0"}])",
     "/fidelity/noise/retention_efficiency", "has 2 entries for 3 spacings",
     "one entry for each of /fidelity/spacings_m"},
    {"TimesOfSomeLevels", R"([{"op": "remove", "path": "/fidelity/cpu_time_s/0"}])",
     "/fidelity/cpu_time_s", "has 2 entries for 3 spacings",
     "one entry for each of /fidelity/spacings_m"},
    {"ScalarizationUnknown",
     R"([{"op": "replace", "path": "/method/scalarization", "value": "weighted"}])",
     "/method/scalarization", "did you mean \"weighted_sum\"?", "\"epsilon_constraint\""},
    {"GainAboveOne", R"([{"op": "replace", "path": "/method/least_gain", "value": 2}])",
     "/method/least_gain", "is too large", "a number from 0 to 1"},
    {"RepeatableAText", R"([{"op": "replace", "path": "/method/repeatable", "value": "yes"}])",
     "/method/repeatable", "must not be a text", "true or false"},
};

class WrongSearch : public testing::TestWithParam<WrongInput> {};

TEST_P(WrongSearch, GivesOneClearIssue) {
  expect_one_issue(full_study(), GetParam(), parse_study);
}

INSTANTIATE_TEST_SUITE_P(Studies, WrongSearch, testing::ValuesIn(wrong_searches), wrong_input_name);

}  // namespace
}  // namespace parapet::designs
