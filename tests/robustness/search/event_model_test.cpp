// Statistics over a distribution of events, on surrogates of design and event, against functions
// whose statistics are known.
#include "parapet/study/event_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fake_study.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/goal_quantity.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using designs::Statistic;
using study::EventModel;

/// Two event variables, both normal.
Json distributed_study(int count = 8) {
  Json study = fake_study();
  study["scenarios"] = {
      {"count", count},
      {"seed", 1},
      {"variables",
       {{"yield_stress_pa", {{"distribution", "normal"}, {"mean", 100}, {"sd", 20}, {"lower", 1}}},
        {"density_kg_m3", {{"distribution", "normal"}, {"mean", 1200}, {"sd", 60}}}}}};
  return study;
}

/// The place of an event's input among the study's event variables.
const designs::EventVariable& variable(const designs::StudySpec& study, const std::string& name) {
  const auto found = std::find_if(study.event_variables.begin(), study.event_variables.end(),
                                  [&](const auto& one) { return one.name == name; });
  return *found;
}

using OfEvent = std::function<double(double a, double h, double stress, double density)>;

/// Designs spread over the box, each under the study's events.
std::vector<records::EvaluationRecord> records_of(const designs::StudySpec& study, int n,
                                                  const OfEvent& force) {
  std::vector<records::EvaluationRecord> list;
  for (int k = 0; k < n; ++k) {
    records::EvaluationRecord record;
    const double a = std::fmod(0.5 + 0.7549 * k, 1.0), h = std::fmod(0.5 + 0.5698 * k, 1.0);
    record.id = records::evaluation_id(k + 1);
    record.ok = true;
    record.spacing = designs::finest_spacing(study);
    record.design = {{"deflector_angle_deg", 60.0 * a}, {"upstream_height_m", 0.04 + 0.06 * h}};
    for (std::size_t e = 0; e < study.scenarios.size(); ++e) {
      records::ScenarioRecord event;
      event.name = study.scenarios[e].name;
      event.weight = study.scenarios[e].weight;
      event.ok = true;
      event.metrics = {{"barrier_1_slam_force_n_per_m",
                        force(a, h, variable(study, "yield_stress_pa").at[e],
                              variable(study, "density_kg_m3").at[e]),
                        ""},
                       {"launch_length_m", std::nullopt, "nothing overflows"},
                       {"retention_efficiency", 1.0 - h / 2.0, ""}};
      record.scenarios.push_back(std::move(event));
    }
    list.push_back(std::move(record));
  }
  return list;
}

double smooth(double a, double h, double stress, double density) {
  return a * a + h * h + stress / 100.0 + 0.002 * (density - 1200.0);
}

study::Quantity force(Statistic statistic, double quantile = 1.0) {
  return {.metric = "barrier_1_slam_force_n_per_m",
          .statistic = statistic,
          .quantile = quantile,
          .lower = {},
          .upper = {},
          .value_when_absent = {}};
}

const designs::Design place{{"deflector_angle_deg", 24.0}, {"upstream_height_m", 0.058}};
constexpr double at_place = 0.4 * 0.4 + 0.3 * 0.3 + 1.0;  // at the mean event

// The force is normal over the events: s.d. hypot(0.2, 0.12). Eight events of eight designs; the
// 2,000 draws leave 0.2 / sqrt(2000) = 0.005 of a mean and about twice that of a quantile.
TEST(EventModel, StatisticsAgreeWithTheDistribution) {
  const designs::StudySpec study = parsed(distributed_study());
  const EventModel model(study, records_of(study, 12, smooth));
  ASSERT_FALSE(model.empty());
  EXPECT_EQ(model.n_designs(), 12U);
  const double sd = std::hypot(0.2, 0.12);
  const auto mean = model.statistic(force(Statistic::mean), place);
  EXPECT_NEAR(mean->value, at_place, 0.01);
  const auto ninety = model.statistic(force(Statistic::quantile, 0.9), place);
  EXPECT_NEAR(ninety->value, at_place + 1.2816 * sd, 0.03);
  study::Quantity within = force(Statistic::probability);
  within.upper = at_place + 0.5 * sd;
  EXPECT_NEAR(model.statistic(within, place)->value, 0.6915, 0.03);
  for (const auto& one : {*mean, *ninety}) {
    EXPECT_LE(one.lower_95, one.value);
    EXPECT_GE(one.upper_95, one.value);
    EXPECT_LT(one.upper_95 - one.lower_95, 0.1) << "the function is smooth: little is left open";
  }
}

// The statistic over the simulated events alone is far less certain: the worst of eight.
TEST(EventModel, AnExpressionIsEvaluatedInEachEvent) {
  Json json = distributed_study();
  json["objectives"][0] = {
      {"name", "cost"},
      {"goal", "minimize"},
      {"statistic", "quantile"},
      {"quantile", 0.9},
      {"expression", "10 * barrier_1_slam_force_n_per_m + launch_length_m + deflector_angle_deg"},
      {"values_when_absent", {{"launch_length_m", 2}}}};
  const designs::StudySpec study = parsed(json);
  const EventModel model(study, records_of(study, 12, smooth));
  const study::Quantity cost = study::objective_quantity(study, study.objectives[0]);
  const double ninety = at_place + 1.2816 * std::hypot(0.2, 0.12);
  EXPECT_NEAR(model.statistic(cost, place)->value, 10.0 * ninety + 2.0 + 24.0, 0.3);
}

// A smooth function of the event is predicted in an event that was left out; one that jumps from
// event to event is not, and the error is its spread.
TEST(EventModel, LeaveOneEventOutTellsWhatIsPredicted) {
  const designs::StudySpec study = parsed(distributed_study());
  const EventModel::Key key{"barrier_1_slam_force_n_per_m", std::nullopt};
  const auto good = EventModel(study, records_of(study, 12, smooth)).leave_one_event_out(key);
  EXPECT_LT(good.rmse, 0.05) << "of a function whose events differ by 0.23";
  EXPECT_GT(good.q_squared, 0.95);
  // Every event has a value of its own, +1 or -1, whatever the design.
  const auto jumps = [](double, double, double stress, double) {
    return std::fmod(std::floor(7.0 * stress), 2.0) == 0.0 ? 1.0 : -1.0;
  };
  const auto bad = EventModel(study, records_of(study, 12, jumps)).leave_one_event_out(key);
  EXPECT_GT(bad.rmse, 0.5);
  EXPECT_LT(bad.q_squared, 0.5);
}

// Listed events have no distribution.
TEST(EventModel, IsEmptyForListedEvents) {
  const designs::StudySpec study = parsed(fake_study_with_scenarios());
  EXPECT_FALSE(study::has_distribution(study));
  EXPECT_TRUE(EventModel(study, {}).empty());
}

class EventStudyTest : public FakeStudyTest {};

// pareto.json states the statistic over 2,000 events and what it rests on; f1 = a^2 + h^2 +
// stress / 1000 of the fake simulator is normal over the events.
TEST_F(EventStudyTest, TheFrontStatesTheStatisticOfTheDistribution) {
  Json json = distributed_study(5);
  json["objectives"][0]["statistic"] = "quantile";
  json["objectives"][0]["quantile"] = 0.9;
  run(parsed(json), "out", FakeSimulator());
  const Json front = this->json("out", "pareto.json");
  ASSERT_FALSE(front["designs"].empty());
  EXPECT_EQ(front["events"]["simulated"], 5);
  EXPECT_EQ(front["events"]["drawn"], 2000);
  EXPECT_EQ(front["events"]["leave_one_event_out"].size(), 3U);
  for (const Json& one : front["designs"]) {
    const auto design = one["design"].get<designs::Design>();
    const double a = scaled_angle(design), h = scaled_height(design);
    EXPECT_EQ(one["objectives"][0]["over_events"], 2000);
    EXPECT_NEAR(one["objectives"][0]["estimate"].get<double>(), a * a + h * h + 0.1 + 1.2816 * 0.02,
                0.01);
  }
}

// The search is told the statistics of the distribution: of every design it was told, by all that
// it was told. The five simulated events alone miss the 0.9 quantile, their fifth in order is their
// worst.
TEST_F(EventStudyTest, TheSearchIsToldTheStatisticOfTheDistribution) {
  Json json = distributed_study(5);
  json["objectives"][0]["statistic"] = "quantile";
  json["objectives"][0]["quantile"] = 0.9;
  const designs::StudySpec study = parsed(json);
  const auto problem = study::make_search_problem(study);
  bayesian::Search search(problem.problem, study::make_search_options(study));
  std::vector<records::EvaluationRecord> told;
  for (const auto& record : records_of(study, 10, smooth)) {
    search.tell_external(study::to_point(study, record.design), 0,
                         study::observation(study, problem, record));
    told.push_back(record);
  }
  const std::size_t metric = problem.problem.objectives[0].metric;
  const double quantile = 1.0 + 1.2816 * std::hypot(0.2, 0.12);
  const auto error = [&](const bayesian::Assessed& one, const records::EvaluationRecord& record) {
    const double a = scaled_angle(record.design), h = scaled_height(record.design);
    return *one.values[metric] - (a * a + h * h + quantile);
  };
  const auto before = search.assessed();
  study::revise_statistics(study, problem, told, search);
  const auto after = search.assessed();
  for (std::size_t k = 0; k < told.size(); ++k) {
    EXPECT_GT(std::abs(error(before[k], told[k])), 0.03) << k;
    EXPECT_LT(std::abs(error(after[k], told[k])), 0.03) << k;
    EXPECT_NEAR(after[k].estimate[metric], *after[k].values[metric], 0.02)
        << "its surrogate follows";
  }
}

// An interrupted study asks the same questions of the same statistics.
TEST_F(EventStudyTest, AResumedStudyIsTheSame) {
  Json json = distributed_study(4);
  json["objectives"][0] = {
      {"name", "cost"},
      {"goal", "minimize"},
      {"statistic", "quantile"},
      {"expression", "10 * barrier_1_slam_force_n_per_m + deflector_angle_deg / 60"}};
  const designs::StudySpec study = parsed(json);
  run(study, "whole", FakeSimulator());
  FakeSimulator::Behaviour stops;
  stops.cancel_after = 37;
  run(study, "parts", FakeSimulator(stops));
  EXPECT_LT(records("parts").size(), records("whole").size());
  run(study, "parts", FakeSimulator());
  EXPECT_EQ(records("parts"), records("whole"));
  EXPECT_EQ(this->json("parts", "pareto.json")["designs"],
            this->json("whole", "pareto.json")["designs"]);
  EXPECT_EQ(this->json("parts", "pareto.json")["events"],
            this->json("whole", "pareto.json")["events"]);
}

}  // namespace
}  // namespace parapet::test
