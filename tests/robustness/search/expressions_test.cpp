// Expressions of metrics in objectives and constraints: scores by hand, over events, in every kind
// of search, and a study that is resumed.
#include <gtest/gtest.h>

#include <cmath>

#include "fake_study.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using study::Event;

/// cost = 3 f1 + height / 0.06 + 2 f2, to be minimised; f1 + f2 is limited.
Json cost_study(Json study) {
  study["terms"] = Json::parse(R"json({
    "steepness": "(upstream_height_m - 0.04) / 0.06",
    "launched_m": {"expression": "2 * launch_length_m",
                   "values_when_absent": {"launch_length_m": 0.25}}})json");
  study["objectives"] = Json::parse(R"json([
    {"name": "cost", "goal": "minimize", "weight": 2, "scale": 4,
     "expression": "3 * barrier_1_slam_force_n_per_m + steepness + launched_m"}])json");
  study["constraints"].push_back(Json::parse(R"json(
    {"name": "both", "expression": "barrier_1_slam_force_n_per_m + launch_length_m", "upper": 1.5,
     "values_when_absent": {"launch_length_m": 0}})json"));
  return study;
}

std::vector<solver::Metric> metrics(double force, std::optional<double> launch) {
  return {{"barrier_1_slam_force_n_per_m", force, ""},
          {"launch_length_m", launch, launch ? "" : "nothing overflows"},
          {"retention_efficiency", 0.9, ""}};
}

const designs::Design half{{"deflector_angle_deg", 30.0}, {"upstream_height_m", 0.07}};

// 3 0.5 + 0.5 + 2 0.4 = 2.8, times 2 over 4; 0.5 + 0.4 = 0.9 of 1.5, scale 1.5. A launch that does
// not exist counts as 0.25 in the cost and as 0 in the limit.
TEST(Expressions, ScoreAsByHand) {
  const designs::StudySpec study = parsed(cost_study(fake_study()));
  const study::Score score = study::score(study, half, metrics(0.5, 0.4));
  EXPECT_NEAR(*score.objectives[0].value, 2.8, 1e-12);
  EXPECT_NEAR(*score.objective_scalar, 1.4, 1e-12);
  ASSERT_EQ(score.metric_violations.size(), 2U);
  EXPECT_NEAR(score.metric_violations[1], (0.9 - 1.5) / 1.5, 1e-12);
  EXPECT_EQ(score.constraints[2].name, "both");
  EXPECT_NEAR(*score.constraints[2].margin, 0.6, 1e-12);
  EXPECT_EQ(study::metric_limit_count(study), 2);
  EXPECT_EQ(study::expression_limit_count(study), 1);

  const study::Score dry = study::score(study, half, metrics(0.5, std::nullopt));
  EXPECT_NEAR(*dry.objectives[0].value, 1.5 + 0.5 + 0.5, 1e-12);
  EXPECT_NEAR(*dry.constraints[2].value, 0.5, 1e-12);
  EXPECT_TRUE(dry.feasible);
}

// A metric that the run was too short to tell leaves the expression without a value, whatever
// stands for one that does not exist.
TEST(Expressions, OfAnUnknownMetricHaveNoValue) {
  const designs::StudySpec study = parsed(cost_study(fake_study()));
  std::vector<solver::Metric> unknown = metrics(0.5, std::nullopt);
  unknown[1].absence = solver::Absence::run_too_short;
  const study::Score score = study::score(study, half, unknown);
  EXPECT_FALSE(score.objectives[0].value);
  EXPECT_NE(score.problem.find("launch_length_m: nothing overflows"), std::string::npos)
      << score.problem;
  EXPECT_FALSE(score.constraints[2].satisfied);
}

std::vector<Event> three_events() {
  return {{"soft", 0.5, metrics(0.1, 0.4)},
          {"usual", 0.3, metrics(0.3, 0.2)},
          {"stiff", 0.2, metrics(0.2, std::nullopt)}};
}

// The expression is evaluated in each event and the statistic taken of its values: 3 f1 + 0.5 +
// 2 f2 = 1.6, 1.8 and (with 0.25) 1.6.
TEST(Expressions, TakeTheirStatisticOverEvents) {
  Json json = cost_study(fake_study_with_scenarios());
  const auto cost = [&](const char* statistic) {
    json["objectives"][0]["statistic"] = statistic;
    return *study::score(parsed(json), half, three_events()).objectives[0].value;
  };
  EXPECT_NEAR(cost("mean"), 0.5 * 1.6 + 0.3 * 1.8 + 0.2 * 1.6, 1e-12);
  EXPECT_NEAR(cost("worst"), 1.8, 1e-12);
  // Worst of both: f1 and f2 are not at their worst in one event.
  EXPECT_NEAR(*study::score(parsed(json), half, three_events()).constraints[2].value, 0.5, 1e-12);
  json["objectives"][0]["upper"] = 1.7;
  EXPECT_NEAR(cost("probability"), 0.7, 1e-12);
}

// The search models the metrics, each once, and never the expression.
TEST(Expressions, AreComposedOfModelledMetrics) {
  const designs::StudySpec study = parsed(cost_study(fake_study()));
  const auto problem = study::make_search_problem(study);
  const auto& metrics = problem.problem.metrics;
  const std::size_t cost = problem.problem.objectives[0].metric;
  ASSERT_TRUE(metrics[cost].is_composed());
  ASSERT_EQ(metrics[cost].composition.inputs.size(), 2U);
  EXPECT_EQ(metrics[metrics[cost].composition.inputs[0]].name, "barrier_1_slam_force_n_per_m");
  EXPECT_NEAR(metrics[cost].composition.value({30.0, 0.07}, {0.5, 0.4}), 2.8, 1e-12);
  // launch_length_m counts as 0.25 in one and as 0 in the other: two surrogates; the force is one.
  const std::size_t both = problem.problem.limits[1].metric;
  ASSERT_TRUE(metrics[both].is_composed());
  EXPECT_EQ(metrics[both].composition.inputs[0], metrics[cost].composition.inputs[0]);
  EXPECT_NE(metrics[both].composition.inputs[1], metrics[cost].composition.inputs[1]);
  EXPECT_EQ(metrics.size(), 6U) << "force, two launches, retention, cost and both";
}

// Over events each metric is modelled in each event, and told the event's value.
TEST(Expressions, AreComposedEventByEvent) {
  Json json = cost_study(fake_study_with_scenarios());
  json["objectives"][0]["statistic"] = "worst";
  const designs::StudySpec study = parsed(json);
  const auto problem = study::make_search_problem(study);
  const auto& cost = problem.problem.metrics[problem.problem.objectives[0].metric];
  ASSERT_EQ(cost.composition.inputs.size(), 6U);
  records::EvaluationRecord record;
  record.ok = true;
  for (const Event& event : three_events()) {
    records::ScenarioRecord one;
    one.name = event.name;
    one.weight = event.weight;
    one.metrics = event.metrics;
    record.scenarios.push_back(one);
  }
  const auto told = study::observation(study, problem, record);
  std::vector<double> inputs;
  for (const std::size_t input : cost.composition.inputs) inputs.push_back(*told.values[input]);
  EXPECT_EQ(inputs, (std::vector<double>{0.1, 0.4, 0.3, 0.2, 0.2, 0.25}));
  EXPECT_NEAR(cost.composition.value({30.0, 0.07}, inputs), 1.8, 1e-12);
}

class ExpressionStudyTest : public FakeStudyTest {};

/// Least cost of the log's feasible designs: at angle share a and height share 0 the cost
/// 3 a^2 + 2 (1 - a)^2 is least at a = 0.4: 1.2.
double least_cost(const std::map<std::string, Json>& records) {
  double least = 1e300;
  for (const auto& [id, record] : records) {
    if (record["status"] == "ok" && record["feasible"] == true) {
      least = std::min(least, record["objectives"][0]["value"].get<double>());
    }
  }
  return least;
}

TEST_F(ExpressionStudyTest, EveryKindOfSearchMinimisesThem) {
  for (const char* algorithm : {"BAYESIAN", "COBYLA", "SOBOL"}) {
    Json json = cost_study(fake_study());
    json["method"]["algorithm"] = algorithm;
    json["method"]["max_evaluations"] = 25;
    run(parsed(json), algorithm, FakeSimulator());
    // 25 Sobol' points lie within 0.2 of everything.
    const double margin = std::string(algorithm) == "SOBOL" ? 0.35 : 0.02;
    const double found = least_cost(records(algorithm));
    EXPECT_LT(found, 1.2 + margin) << algorithm;
    EXPECT_GE(found, 1.2 - 1e-9) << algorithm;
  }
}

// An interrupted study goes on as an undisturbed one.
TEST_F(ExpressionStudyTest, AResumedStudyIsTheSame) {
  Json json = cost_study(fake_study_with_scenarios());
  json["objectives"][0]["statistic"] = "worst";
  const designs::StudySpec study = parsed(json);
  run(study, "whole", FakeSimulator());
  FakeSimulator::Behaviour stops;
  stops.cancel_after = 26;
  run(study, "parts", FakeSimulator(stops));
  EXPECT_LT(records("parts").size(), records("whole").size());
  run(study, "parts", FakeSimulator());
  EXPECT_EQ(records("parts"), records("whole"));
  EXPECT_EQ(this->json("parts", "pareto.json")["designs"],
            this->json("whole", "pareto.json")["designs"]);
}

// The front says what the surrogates of the metrics say of the expression.
TEST_F(ExpressionStudyTest, TheFrontHoldsEstimatesOfThem) {
  run(parsed(cost_study(fake_study())), "out", FakeSimulator());
  const Json front = json("out", "pareto.json");
  ASSERT_FALSE(front["designs"].empty());
  const Json& cost = front["designs"][0]["objectives"][0];
  EXPECT_NEAR(cost["estimate"].get<double>(), cost["value"].get<double>(), 0.1);
  EXPECT_LE(cost["lower_95"].get<double>(), cost["estimate"].get<double>());
  EXPECT_FALSE(front["designs"][0]["constraints"][2]["estimates"].empty());
  const Json surrogates = json("out", "surrogates.json");
  int composed = 0;
  for (const Json& metric : surrogates["metrics"]) {
    if (!metric.contains("inputs")) continue;
    ++composed;
    EXPECT_FALSE(metric.contains("surrogate")) << "an expression is not modelled";
  }
  EXPECT_EQ(composed, 2);
}

}  // namespace
}  // namespace parapet::test
