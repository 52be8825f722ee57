// Statistics over events, by hand: four events of different weight.
#include <gtest/gtest.h>

#include "fake_study.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using designs::Statistic;
using study::Event;
using study::Quantity;
using study::quantity_value;

std::vector<Event> events(const std::vector<std::optional<double>>& values) {
  const std::vector<double> weights{0.4, 0.3, 0.2, 0.1};
  std::vector<Event> result;
  for (std::size_t k = 0; k < values.size(); ++k) {
    result.push_back({"event" + std::to_string(k),
                      weights[k],
                      {{"x", values[k], values[k] ? "" : "nothing overflows"}}});
  }
  return result;
}

Quantity quantity(Statistic statistic) {
  return {.metric = "x", .statistic = statistic, .lower = {}, .upper = {}, .value_when_absent = {}};
}

TEST(Statistics, MeanIsWeighted) {
  // 0.4 1 + 0.3 2 + 0.2 3 + 0.1 10
  EXPECT_NEAR(*quantity_value(quantity(Statistic::mean), events({1.0, 2.0, 3.0, 10.0})).value, 2.6,
              1e-15);
}

TEST(Statistics, WorstIsAtTheBadEnd) {
  Quantity worst = quantity(Statistic::worst);
  EXPECT_EQ(quantity_value(worst, events({1.0, 2.0, 3.0, 10.0})).value, 10.0);
  worst.high_is_good = true;
  EXPECT_EQ(quantity_value(worst, events({1.0, 2.0, 3.0, 10.0})).value, 1.0);
}

TEST(Statistics, QuantileIsTheValueThatSoManyEventsMeetOrBetter) {
  Quantity at = quantity(Statistic::quantile);
  const auto values = events({1.0, 2.0, 3.0, 10.0});
  const std::vector<std::pair<double, double>> low_is_good{{0.4, 1.0}, {0.41, 2.0},  {0.7, 2.0},
                                                           {0.9, 3.0}, {0.91, 10.0}, {1.0, 10.0}};
  for (const auto& [share, value] : low_is_good) {
    at.quantile = share;
    EXPECT_EQ(quantity_value(at, values).value, value) << share;
  }
  at.high_is_good = true;  // 10 (0.1), 3 (0.3), 2 (0.6), 1 (1.0)
  const std::vector<std::pair<double, double>> high{
      {0.1, 10.0}, {0.3, 3.0}, {0.6, 2.0}, {0.9, 1.0}};
  for (const auto& [share, value] : high) {
    at.quantile = share;
    EXPECT_EQ(quantity_value(at, values).value, value) << share;
  }
}

TEST(Statistics, ProbabilityIsTheWeightWithinTheLimits) {
  Quantity within = quantity(Statistic::probability);
  within.lower = 2.0;
  EXPECT_NEAR(*quantity_value(within, events({1.0, 2.0, 3.0, 10.0})).value, 0.6, 1e-15);
  within.upper = 3.0;
  EXPECT_NEAR(*quantity_value(within, events({1.0, 2.0, 3.0, 10.0})).value, 0.5, 1e-15);
}

TEST(Statistics, AbsentValuesTakeTheEndThatTheSpecGivesThem) {
  const auto values = events({1.0, {}, 3.0, 10.0});
  for (const bool good : {true, false}) {
    Quantity mean = quantity(Statistic::mean);
    mean.absent_is_good = good;
    const auto found = quantity_value(mean, values);
    EXPECT_TRUE(found.absent);
    EXPECT_EQ(found.reason, "nothing overflows (event1)");
    EXPECT_EQ(found.value.has_value(), good);
    // (0.4 1 + 0.2 3 + 0.1 10) / 0.7
    if (good) {
      EXPECT_NEAR(*found.value, 2.0 / 0.7, 1e-15);
    }
    Quantity worst = quantity(Statistic::worst);
    worst.absent_is_good = good;
    EXPECT_EQ(quantity_value(worst, values).value,
              good ? std::optional(10.0) : std::optional<double>());
    Quantity half = quantity(Statistic::quantile);
    half.quantile = 0.5;
    half.absent_is_good = good;
    // Good: absent (0.3), 1 (0.7). Bad: 1 (0.4), 3 (0.6).
    EXPECT_EQ(quantity_value(half, values).value, good ? 1.0 : 3.0);
    half.quantile = good ? 0.2 : 0.95;
    EXPECT_FALSE(quantity_value(half, values).value.has_value()) << "it falls on the absent one";
    Quantity probability = quantity(Statistic::probability);
    probability.upper = 2.0;
    probability.absent_is_good = good;
    EXPECT_NEAR(*quantity_value(probability, values).value, good ? 0.7 : 0.4, 1e-15);
  }
  Quantity replaced = quantity(Statistic::mean);
  replaced.value_when_absent = -1.0;
  EXPECT_NEAR(*quantity_value(replaced, values).value, 0.4 - 0.3 + 0.6 + 1.0, 1e-15);
}

/// Force values 1, 2, 3 under soft (0.5), usual (0.3) and stiff (0.2).
std::vector<Event> forces(double first, double second, double third,
                          std::optional<double> launch = 0.5) {
  std::vector<Event> result;
  const std::vector<double> values{first, second, third}, weights{0.5, 0.3, 0.2};
  for (std::size_t k = 0; k < 3; ++k) {
    result.push_back({"event",
                      weights[k],
                      {{"barrier_1_slam_force_n_per_m", values[k], ""},
                       {"launch_length_m", launch, launch ? "" : "nothing overflows"},
                       {"retention_efficiency", 0.9, ""}}});
  }
  return result;
}

const designs::Design design{{"deflector_angle_deg", 30.0}, {"upstream_height_m", 0.07}};

Json study_with(const std::string& objectives, const std::string& constraints) {
  Json json = fake_study_with_scenarios();
  json["objectives"] = Json::parse(objectives);
  json["constraints"] = Json::parse(constraints);
  return json;
}

constexpr const char* force = R"([{"metric": "barrier_1_slam_force_n_per_m", "goal": "minimize"}])";

TEST(ScenarioScoring, ObjectivesOfEveryKindAddUp) {
  const auto study = parsed(study_with(R"json([
    {"metric": "barrier_1_slam_force_n_per_m", "goal": "minimize", "statistic": "worst"},
    {"name": "mean_force", "metric": "barrier_1_slam_force_n_per_m", "goal": "minimize", "weight": 2},
    {"name": "strong", "metric": "barrier_1_slam_force_n_per_m", "goal": "maximize",
     "statistic": "probability", "lower": 1.5},
    {"name": "height", "expression": "upstream_height_m * 10", "goal": "minimize"}])json",
                                       "[]"));
  const auto score = study::score(study, design, forces(1.0, 2.0, 3.0));
  ASSERT_EQ(score.objectives.size(), 4U);
  EXPECT_EQ(score.objectives[0].value, 3.0);
  EXPECT_NEAR(*score.objectives[1].value, 1.7, 1e-15);
  EXPECT_NEAR(*score.objectives[2].value, 0.5, 1e-15);
  EXPECT_NEAR(*score.objectives[3].value, 0.7, 1e-15);
  EXPECT_EQ(score.objectives[3].metric, "height");
  EXPECT_NEAR(*score.objective_scalar, 3.0 + 2.0 * 1.7 - 0.5 + 0.7, 1e-14);
  const auto minimized = [&] {
    records::EvaluationRecord record;
    record.objectives = score.objectives;
    return study::minimized_objectives(record);
  }();
  EXPECT_NEAR(minimized[2], -0.5, 1e-15) << "a maximised objective changes its sign";
}

TEST(ScenarioScoring, WorstCaseConstraintNamesTheNearerLimit) {
  const auto study = parsed(study_with(force, R"([
    {"metric": "barrier_1_slam_force_n_per_m", "lower": 0.9, "upper": 4, "scale": 2}])"));
  const auto score = study::score(study, design, forces(1.0, 2.0, 3.0));
  ASSERT_EQ(score.metric_violations.size(), 2U);
  EXPECT_NEAR(score.metric_violations[0], (0.9 - 1.0) / 2.0, 1e-15) << "the lowest counts";
  EXPECT_NEAR(score.metric_violations[1], (3.0 - 4.0) / 2.0, 1e-15) << "the highest counts";
  EXPECT_EQ(score.constraints[0].value, 1.0);
  EXPECT_NEAR(*score.constraints[0].margin, 0.1, 1e-15);
  EXPECT_EQ(score.constraints[0].lower, 0.9);
  EXPECT_EQ(score.constraints[0].upper, 4.0);
  EXPECT_TRUE(score.feasible);
  EXPECT_FALSE(study::score(study, design, forces(0.8, 2.0, 3.0)).feasible);
  EXPECT_FALSE(study::score(study, design, forces(1.0, 2.0, 4.1)).feasible);
  EXPECT_EQ(study::metric_limit_count(study), 2);
}

TEST(ScenarioScoring, ProbabilityConstraintIsOneLimit) {
  const auto study = parsed(study_with(force, R"([
    {"metric": "barrier_1_slam_force_n_per_m", "upper": 2, "lower": 0,
     "statistic": "probability", "quantile": 0.75}])"));
  EXPECT_EQ(study::metric_limit_count(study), 1);
  const auto met = study::score(study, design, forces(1.0, 2.0, 3.0));
  ASSERT_EQ(met.metric_violations.size(), 1U);
  EXPECT_NEAR(met.metric_violations[0], 0.75 - 0.8, 1e-15);
  EXPECT_NEAR(*met.constraints[0].value, 0.8, 1e-15);
  EXPECT_EQ(met.constraints[0].lower, 0.75);
  EXPECT_TRUE(met.feasible);
  const auto missed = study::score(study, design, forces(1.0, 2.1, 3.0));
  EXPECT_NEAR(missed.metric_violations[0], 0.75 - 0.5, 1e-15);
  EXPECT_FALSE(missed.feasible);
}

TEST(ScenarioScoring, AbsentMetricOfAConstraintCountsAsTheSpecSays) {
  const auto with = [](const std::string& more) {
    return parsed(
        study_with(force, R"([{"metric": "launch_length_m", "upper": 0.4)" + more + "}]"));
  };
  const auto nothing = forces(1.0, 2.0, 3.0, std::nullopt);
  EXPECT_TRUE(study::score(with(""), design, nothing).feasible);
  const auto strict = study::score(with(R"(, "satisfied_when_absent": false)"), design, nothing);
  EXPECT_FALSE(strict.feasible);
  EXPECT_EQ(strict.metric_violations, std::vector<double>{1.0});
  const auto replaced = study::score(with(R"(, "value_when_absent": 0.5)"), design, nothing);
  EXPECT_FALSE(replaced.feasible);
  EXPECT_NEAR(replaced.metric_violations[0], (0.5 - 0.4) / 0.4, 1e-15);
  EXPECT_EQ(replaced.constraints[0].value, 0.5);
}

// What a longer or finer run would tell is no value that does not exist.
TEST(ScenarioScoring, AnUnknownMetricIsNeverReplacedNorGood) {
  const auto with = [](const std::string& more) {
    return parsed(
        study_with(force, R"([{"metric": "launch_length_m", "upper": 0.4)" + more + "}]"));
  };
  auto unknown = forces(1.0, 2.0, 3.0, std::nullopt);
  for (study::Event& event : unknown) {
    for (solver::Metric& metric : event.metrics) {
      if (!metric.value) metric.absence = solver::Absence::run_too_short;
    }
  }
  for (const char* more :
       {"", R"(, "value_when_absent": 0.1)", R"(, "satisfied_when_absent": true)"}) {
    const auto score = study::score(with(more), design, unknown);
    EXPECT_FALSE(score.feasible) << more;
    EXPECT_EQ(score.metric_violations, std::vector<double>{1.0}) << more;
  }
}

TEST(Statistics, AnUnknownValueStandsAtTheBadEnd) {
  auto values = events({1.0, 2.0, 3.0, std::nullopt});
  values.back().metrics.front().absence = solver::Absence::too_coarse;
  for (const Statistic statistic : {Statistic::mean, Statistic::worst, Statistic::quantile}) {
    Quantity any = quantity(statistic);
    any.absent_is_good = true;
    any.value_when_absent = 0.0;
    const auto found = quantity_value(any, values);
    EXPECT_FALSE(found.value);
    EXPECT_TRUE(found.unknown);
    values.back().metrics.front().absence = solver::Absence::does_not_exist;
    EXPECT_TRUE(quantity_value(any, values).value);
    values.back().metrics.front().absence = solver::Absence::too_coarse;
  }
  Quantity at = quantity(Statistic::quantile);
  at.absent_is_good = true;
  at.quantile = 0.9;  // the events with a value have so much weight
  EXPECT_EQ(quantity_value(at, values).value, 3.0);
  EXPECT_FALSE(quantity_value(at, values).unknown);
  at.statistic = Statistic::probability;
  at.upper = 100.0;
  EXPECT_NEAR(*quantity_value(at, values).value, 0.9, 1e-15);
}

TEST(ScenarioScoring, FormulaOfAnInactiveVariableCountsItAsNought) {
  Json json = fake_study();
  json["variables"] = Json::parse(R"({
    "deflector": {"options": {"none": {"remove": ["/barriers/0/deflector"]}, "plate": {}}},
    "deflector_angle_deg": {"lower": 0, "upper": 60, "active_when": {"deflector": "plate"}},
    "upstream_height_m": {"lower": 0.04, "upper": 0.1}})");
  const auto study = parsed(json);
  EXPECT_NEAR(*study::formula_value(study, "deflector_angle_deg + upstream_height_m",
                                    {{"deflector", 0.0}, {"upstream_height_m", 0.05}}),
              0.05, 1e-15);
  EXPECT_FALSE(study::formula_value(study, "1 / deflector_angle_deg",
                                    {{"deflector", 0.0}, {"upstream_height_m", 0.05}})
                   .has_value());
}

}  // namespace
}  // namespace parapet::test
