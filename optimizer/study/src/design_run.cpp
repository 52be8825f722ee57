#include "parapet/study/design_run.hpp"

#include <atomic>
#include <stdexcept>
#include <utility>

#include "parapet/study/hashes.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/side_by_side.hpp"

namespace parapet::study {
namespace {

using designs::Json;

reports::ScenarioRecord scenario_record(const designs::Scenario* scenario,
                                        const Simulation& simulation) {
  reports::ScenarioRecord record;
  if (scenario != nullptr) {
    record.name = scenario->name;
    record.weight = scenario->weight;
  }
  record.ok = simulation.ok;
  record.reason = simulation.reason;
  record.metrics = simulation.metrics;
  record.wall_time = simulation.wall_time;
  record.cpu_time = simulation.cpu_time;
  record.particle_steps = simulation.particle_steps;
  return record;
}

/// Scores a record whose simulations all ended well.
void record_score(const designs::StudySpec& study, reports::EvaluationRecord& record) {
  Score scored = score(study, record.design, events_of(record));
  record.ok = scored.problem.empty();
  record.reason = scored.problem;
  record.objectives = std::move(scored.objectives);
  record.objective_scalar = scored.objective_scalar;
  record.constraints = std::move(scored.constraints);
  record.feasible = scored.feasible;
}

}  // namespace

DesignRun::DesignRun(const designs::StudySpec& study, designs::Design design, double spacing)
    : study_(study),
      design_(std::move(design)),
      spacing_(spacing),
      simulations_(study.scenarios.empty() ? 1 : study.scenarios.size()) {}

const designs::Scenario* DesignRun::scenario(std::size_t event) const {
  return study_.scenarios.empty() ? nullptr : &study_.scenarios[event];
}

void DesignRun::set(std::size_t event, Simulation simulation) {
  simulations_[event] = std::move(simulation);
}

void DesignRun::fail(reports::EvaluationRecord& record, const std::string& reason) const {
  record.ok = false;
  record.reason = reason;
  record.constraints = score_expressions(study_, design_);
}

reports::EvaluationRecord DesignRun::record() const {
  reports::EvaluationRecord record;
  record.design = design_;
  record.options = designs::option_names(study_, design_);
  record.spacing = spacing_;
  std::string problem;
  std::vector<Event> events;
  for (std::size_t k = 0; k < size(); ++k) {
    reports::ScenarioRecord one = scenario_record(scenario(k), simulations_[k].value());
    record.wall_time += one.wall_time;
    record.cpu_time += one.cpu_time;
    record.particle_steps += one.particle_steps;
    if (!one.ok && problem.empty()) {
      problem = scenario(k) == nullptr ? one.reason : "scenario " + one.name + ": " + one.reason;
    }
    if (one.ok || scenario(k) == nullptr) events.push_back({one.name, one.weight, one.metrics});
    if (scenario(k) != nullptr) record.scenarios.push_back(std::move(one));
  }
  record.metrics = mean_metrics(events);
  if (problem.empty()) {
    record_score(study_, record);
  } else {
    fail(record, problem);
  }
  return record;
}

Json DesignRun::report(const reports::ProgramInfo& program) const {
  Json report;
  report["provenance"] = study_provenance(study_, program);
  if (!study_.scenarios.empty()) return report;
  Json details = simulations_.front().value().report;
  if (details.contains("numerics")) {
    report["provenance"]["numerics"] = details["numerics"];
    details.erase("numerics");
  }
  if (details.is_object()) report.update(details);
  return report;
}

std::optional<DesignRun> run_design(const designs::StudySpec& study, const designs::Design& design,
                                    double spacing, const Simulator& simulator, int jobs,
                                    const solver::Callbacks& callbacks) {
  DesignRun run(study, design, spacing);
  std::atomic<bool> cancelled = false;
  run_side_by_side(
      run.size(), jobs,
      [&](std::size_t k, int threads) {
        Simulation simulation = simulator({.study = study,
                                           .design = design,
                                           .scenario = run.scenario(k),
                                           .spacing = spacing,
                                           .threads = threads,
                                           .callbacks = callbacks});
        if (simulation.cancelled) cancelled = true;
        run.set(k, std::move(simulation));
      },
      [&] { return cancelled.load(); });
  if (cancelled) return std::nullopt;
  return run;
}

double finest_spacing(const designs::StudySpec& study) {
  if (!study.fidelity.empty()) return study.fidelity.front().spacing;
  return study.base_case.at("/numerics/spacing_m"_json_pointer).get<double>();
}

Json evaluation_report(const reports::EvaluationRecord& record, const Json& report) {
  Json json;
  json["format"] = "parapet-evaluation/1";
  json.update(reports::to_json(record));
  json.update(report);
  return json;
}

Json simulation_report(const DesignRun& run, std::size_t event, const Json& provenance) {
  const Simulation& simulation = run.simulation(event).value();
  Json json;
  json["format"] = "parapet-simulation/1";
  json["design"] = run.design();
  json["spacing_m"] = run.spacing();
  json["scenario"] = reports::to_json(scenario_record(run.scenario(event), simulation));
  json["provenance"] = provenance;
  if (simulation.report.is_object()) json["details"] = simulation.report;
  return json;
}

StoredSimulation stored_simulation(const Json& json) {
  if (json.at("format") != "parapet-simulation/1") {
    throw std::runtime_error("not a parapet-simulation/1");
  }
  StoredSimulation stored;
  stored.design = json.at("design").get<designs::Design>();
  stored.spacing = json.at("spacing_m").get<double>();
  const auto record = reports::scenario_from_json(json.at("scenario"));
  stored.scenario = record.name;
  stored.simulation.ok = record.ok;
  stored.simulation.reason = record.reason;
  stored.simulation.metrics = record.metrics;
  stored.simulation.wall_time = record.wall_time;
  stored.simulation.cpu_time = record.cpu_time;
  stored.simulation.particle_steps = record.particle_steps;
  if (json.contains("details")) stored.simulation.report = json["details"];
  return stored;
}

Json study_provenance(const designs::StudySpec& study, const reports::ProgramInfo& program) {
  Json json = reports::provenance_json(program, study_hash(study));
  json["seed"] = study.method.seed;
  return json;
}

}  // namespace parapet::study
