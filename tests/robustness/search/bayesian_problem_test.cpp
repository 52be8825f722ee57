// A study as the search sees it: quantities once each, limits, noise, levels, points.
#include "parapet/study/bayesian_problem.hpp"

#include <cmath>

#include "fake_study.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::test {
namespace {

using designs::Json;

TEST(StudyAsSearchProblem, SharesMetricsBetweenGoalsAndKeepsFormulasExact) {
  Json json = fake_study();
  json["objectives"].push_back(
      Json::parse(R"({"name": "height", "expression": "upstream_height_m", "goal": "minimize"})"));
  json["constraints"].push_back(
      Json::parse(R"({"metric": "barrier_1_slam_force_n_per_m", "upper": 3, "lower": 0})"));
  const auto study = parsed(json);
  const auto problem = study::make_search_problem(study);
  // With one event a worst value is the value: objective and constraint on the force are one.
  ASSERT_EQ(problem.metrics.size(), 4U);
  ASSERT_EQ(problem.problem.objectives.size(), 3U);
  ASSERT_EQ(problem.problem.limits.size(), 2U);
  EXPECT_EQ(problem.problem.limits[1].metric, problem.problem.objectives[0].metric);
  EXPECT_EQ(problem.problem.limits[1].lower, 0.0);
  EXPECT_EQ(problem.problem.limits[1].upper, 3.0);
  const auto& height = problem.problem.metrics[problem.problem.objectives[2].metric];
  EXPECT_EQ(height.exact({30.0, 0.07}), 0.07);
  ASSERT_EQ(problem.problem.cheap_constraints({60.0, 0.1}).size(), 2U);
  EXPECT_NEAR(problem.problem.cheap_constraints({60.0, 0.1})[0], (2.0 - 1.7) / 1.7, 1e-12);
  EXPECT_LT(problem.problem.cheap_constraints({60.0, 0.1})[1], 0.0) << "the formula is finite";
}

// The search evaluates formulas that were made ready once; the log states those of formula_value().
TEST(StudyAsSearchProblem, FormulasHaveTheValuesThatTheLogStates) {
  Json json = fake_study();
  json["objectives"].push_back(Json::parse(
      R"({"name": "inverse", "expression": "1 / (deflector_angle_deg - 30) + upstream_height_m", "goal": "minimize"})"));
  const auto study = parsed(json);
  const auto problem = study::make_search_problem(study);
  const auto& inverse = problem.problem.metrics[problem.problem.objectives.back().metric];
  const std::string formula = study.objectives.back().formula;
  for (const double angle : {0.0, 12.5, 30.0, 59.9}) {
    const bayesian::Point x{angle, 0.07};
    const auto design = study::to_design(study, problem.problem.space, x);
    const auto value = study::formula_value(study, formula, design);
    EXPECT_EQ(value.has_value(), angle != 30.0);
    if (value) {
      EXPECT_EQ(inverse.exact(x), *value);
    } else {
      EXPECT_TRUE(std::isnan(inverse.exact(x)));
    }
    std::vector<double> g = study::expression_violations(study, design);
    g.push_back(value ? -1.0 : 1.0);
    EXPECT_EQ(problem.problem.cheap_constraints(x), g);
  }
}

TEST(StudyAsSearchProblem, WorstCaseWithTwoLimitsIsTwoQuantities) {
  Json json = fake_study_with_scenarios();
  json["constraints"].push_back(
      Json::parse(R"({"metric": "barrier_1_slam_force_n_per_m", "upper": 3, "lower": 0.01})"));
  const auto study = parsed(json);
  const auto problem = study::make_search_problem(study);
  ASSERT_EQ(problem.problem.limits.size(), 3U);
  const auto& lower = problem.problem.limits[1];
  const auto& upper = problem.problem.limits[2];
  EXPECT_NE(lower.metric, upper.metric);
  EXPECT_TRUE(problem.metrics[lower.metric].quantity.high_is_good);
  EXPECT_FALSE(problem.metrics[upper.metric].quantity.high_is_good);
  EXPECT_TRUE(std::isinf(lower.upper));
  EXPECT_TRUE(std::isinf(upper.lower));
}

TEST(StudyAsSearchProblem, NoiseOfAMeanShrinksWithTheWeightsAndSharesStayShares) {
  Json json = fake_study_with_scenarios();
  json["fidelity"] = Json::parse(R"({"spacings_m": [0.01, 0.02], "cpu_time_s": [10, 1],
    "noise": {"barrier_1_slam_force_n_per_m": [1, 2], "retention_efficiency": [0.01, 0.02]}})");
  json["objectives"].push_back(Json::parse(
      R"({"name": "held", "metric": "launch_length_m", "statistic": "probability", "upper": 0.5,
          "value_when_absent": 0})"));
  const auto study = parsed(json);
  const auto problem = study::make_search_problem(study);
  const auto& metrics = problem.problem.metrics;
  const auto& force = metrics[problem.problem.objectives[0].metric];
  const double factor = std::sqrt(0.25 + 0.09 + 0.04);
  ASSERT_EQ(force.known_noise.size(), 2U);
  EXPECT_NEAR(force.known_noise[0], factor, 1e-15);
  EXPECT_NEAR(force.known_noise[1], 2.0 * factor, 1e-15);
  EXPECT_EQ(force.least, 0.0);
  const auto& retention = metrics[problem.problem.limits[0].metric];
  EXPECT_EQ(retention.known_noise, (std::vector<double>{0.01, 0.02})) << "of a worst value";
  EXPECT_EQ(retention.greatest, 1.0);
  const auto& held = metrics[problem.problem.objectives[2].metric];
  EXPECT_TRUE(held.known_noise.empty());
  EXPECT_EQ(held.least, 0.0);
  EXPECT_EQ(held.greatest, 1.0);
  ASSERT_EQ(problem.problem.levels.size(), 2U);
  EXPECT_EQ(problem.problem.levels[0].seconds, 30.0) << "three events";
  EXPECT_EQ(problem.problem.levels[1].seconds, 3.0);
  EXPECT_EQ(study::level_of(problem, 0.02), 1);
  EXPECT_FALSE(study::level_of(problem, 0.03).has_value());
}

TEST(StudyAsSearchProblem, UnknownCostsFollowTheSpacing) {
  Json json = fake_study();
  json["fidelity"] = Json::parse(R"({"spacings_m": [0.01, 0.02]})");
  const auto study = parsed(json);
  const auto problem = study::make_search_problem(study);
  EXPECT_NEAR(problem.problem.levels[0].seconds / problem.problem.levels[1].seconds,
              std::pow(2.0, 3.3), 1e-9);
}

TEST(StudyAsSearchProblem, DesignsAndPointsAreTheSameThing) {
  Json json = fake_study();
  json["variables"] = Json::parse(R"({
    "deflector": {"options": {"none": {"remove": ["/barriers/0/deflector"]}, "plate": {}}},
    "deflector_angle_deg": {"lower": 0, "upper": 60, "type": "integer",
                            "active_when": {"deflector": "plate"}},
    "upstream_height_m": {"lower": 0.04, "upper": 0.1}})");
  const auto study = parsed(json);
  const auto space = study::make_space(study);
  const designs::Design without{{"deflector", 0.0}, {"upstream_height_m", 0.05}};
  const designs::Design with{
      {"deflector", 1.0}, {"deflector_angle_deg", 45.0}, {"upstream_height_m", 0.05}};
  for (const auto& design : {without, with}) {
    EXPECT_EQ(study::to_design(study, space, study::to_point(study, design)), design);
  }
  EXPECT_TRUE(std::isnan(study::to_point(study, without)[1]));
  EXPECT_EQ(study::to_design(study, space, {1.0, 44.6, 0.05}), with) << "integers are rounded";
}

TEST(StudyAsSearchProblem, ObservationsHaveRepeatableCosts) {
  const auto study = parsed(fake_study());
  const auto problem = study::make_search_problem(study);
  records::EvaluationRecord record;
  record.ok = true;
  record.spacing = 0.01;
  record.cpu_time = 123.0;
  record.particle_steps = 2e6;
  record.metrics = {{"barrier_1_slam_force_n_per_m", 4.0, ""},
                    {"launch_length_m", {}, "nothing overflows"},
                    {"retention_efficiency", 0.9, ""}};
  const auto seen = study::observation(study, problem, record);
  EXPECT_TRUE(seen.ok);
  EXPECT_EQ(seen.values[problem.problem.objectives[0].metric], 4.0);
  EXPECT_EQ(seen.values[problem.problem.objectives[1].metric], 0.0) << "value_when_absent";
  EXPECT_EQ(seen.seconds, study::nominal_seconds(2e6)) << "not the measured time";
}

}  // namespace
}  // namespace parapet::test
