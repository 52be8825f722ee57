#include "trade_off.hpp"

#include <algorithm>

namespace parapet::test {
namespace {

designs::StudySpec spec() {
  return designs::parse_study(designs::Json::parse(R"({
    "format": "parapet-study/1",
    "name": "two ends",
    "case": {
      "channel": {"length_m": 1.2},
      "reservoir": {"length_m": 0.2, "height_m": 0.1},
      "barriers": [{"foot_x_m": 0.4, "height_m": 0.15,
                    "deflector": {"angle_deg": 30, "length_m": 0.04}}],
      "run": {"stop_time_s": 0.5}
    },
    "variables": {
      "height_m": {"lower": 0.1, "upper": 0.2, "targets": ["/barriers/0/height_m"]},
      "deflector": {"type": "choice", "options": {
        "none": {"remove": ["/barriers/0/deflector"]}, "plate": {}}},
      "angle_deg": {"lower": 0, "upper": 60, "targets": ["/barriers/0/deflector/angle_deg"],
                    "active_when": {"deflector": ["plate"]}}
    },
    "objectives": [
      {"metric": "retention_efficiency", "goal": "maximize", "statistic": "mean"},
      {"name": "reach_m", "metric": "launch_length_m", "goal": "minimize", "statistic": "worst",
       "value_when_absent": 0}],
    "constraints": [{"name": "load", "metric": "barrier_1_slam_force_n_per_m", "upper": 100,
                     "statistic": "worst"}],
    "scenarios": [{"name": "soft", "weight": 0.5, "set": {"yield_stress_pa": 50}},
                  {"name": "stiff", "weight": 0.5, "set": {"yield_stress_pa": 200}}],
    "fidelity": {"spacings_m": [0.01, 0.02]},
    "method": {"algorithm": "BAYESIAN", "max_evaluations": 9, "seed": 5}})"),
                              "test");
}

}  // namespace

TradeOff::TradeOff()
    : study_{.folder = "two-ends",
             .spec = spec(),
             .spec_hash = "0123456789abcdef",
             .provenance = {{"program_version", "9.9.9"}, {"seed", 5}},
             .state = "done",
             .designs = {}} {}

records::EvaluationRecord TradeOff::record(double height, std::optional<double> angle,
                                           double retention, double reach, double force,
                                           double spacing) {
  records::EvaluationRecord record;
  record.stage = "search";
  record.design = {{"height_m", height}, {"deflector", angle ? 1.0 : 0.0}};
  if (angle) record.design["angle_deg"] = *angle;
  record.options = {{"deflector", angle ? "plate" : "none"}};
  record.ok = true;
  record.metrics = {{"retention_efficiency", retention, ""},
                    {"launch_length_m", reach, ""},
                    {"barrier_1_slam_force_n_per_m", force, ""}};
  record.objectives = {{"retention_efficiency", designs::Goal::maximize, 1.0, retention, false},
                       {"reach_m", designs::Goal::minimize, 1.0, reach, false}};
  record.objective_scalar = reach - retention;
  record.constraints = {{"load", force, std::nullopt, 100.0, force <= 100.0, 100.0 - force}};
  record.feasible = force <= 100.0;
  record.spacing = spacing;
  for (const char* name : {"soft", "stiff"}) {
    records::ScenarioRecord scenario;
    scenario.name = name;
    scenario.weight = 0.5;
    scenario.ok = true;
    scenario.metrics = record.metrics;
    record.scenarios.push_back(scenario);
  }
  return record;
}

void TradeOff::add(double height, std::optional<double> angle, double retention, double reach,
                   double force, double spacing) {
  study_.designs.push_back(record(height, angle, retention, reach, force, spacing));
  study_.designs.back().id = records::evaluation_id(static_cast<int>(study_.designs.size()));
}

void TradeOff::add_front() {
  add(0.20, 30.0, 0.95, 0.30);
  add(0.18, std::nullopt, 0.90, 0.12);
  add(0.15, 20.0, 0.60, 0.10);
  add(0.12, 10.0, 0.50, 0.02);
  add(0.17, 25.0, 0.85, 0.20);              // 0005: dominated by 0002
  add(0.16, 35.0, 0.99, 0.01, 150.0);       // 0006: best in all, breaks the limit
  add(0.14, 15.0, 0.99, 0.01, 50.0, 0.02);  // 0007: best in all, but coarse
}

void TradeOff::confirm(const std::string& pick, const std::string& role, const std::string& stage,
                       double retention, double reach, double force) {
  records::EvaluationRecord one = record(0.18, std::nullopt, retention, reach, force, 0.01);
  one.id = pick + "-" + role;
  one.stage = stage;
  study_.confirmations.push_back(std::move(one));
}

void TradeOff::estimate(const std::map<std::string, double>& probabilities) {
  study::StoredFront front{.designs = {},
                           .reference = {0.4, 0.4},
                           .hypervolume = 0.2,
                           .history = {{1, 1.0, 0.1}, {2, 2.0, 0.2}}};
  for (const auto& [id, probability] : probabilities) {
    const auto design = std::ranges::find(study_.designs, id, &records::EvaluationRecord::id);
    study::DesignEstimates one{.id = id, .objectives = {}, .probability_feasible = probability};
    for (const records::ObjectiveRecord& objective : design->objectives) {
      const double value = objective.value.value();
      one.objectives.push_back({value, value - 0.0196, value + 0.0196});
    }
    front.designs.push_back(std::move(one));
  }
  study_.front = std::move(front);
}

}  // namespace parapet::test
