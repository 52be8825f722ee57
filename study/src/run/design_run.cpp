#include "parapet/study/design_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parapet/records/hashes.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/simulator.hpp"
#include "parapet/study/thread_count.hpp"
#include "simulate_in_order.hpp"

namespace parapet::study {
namespace {

using designs::Json;

/// Scores a record whose simulations all ended well.
void record_score(const designs::StudySpec& study, records::EvaluationRecord& record) {
  Score scored = score(study, record.design, events_of(record));
  record.ok = scored.problem.empty();
  record.reason = scored.problem;
  record.objectives = std::move(scored.objectives);
  record.objective_scalar = scored.objective_scalar;
  record.constraints = std::move(scored.constraints);
  record.feasible = scored.feasible;
  record.terms = std::move(scored.terms);
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

SimulationTask DesignRun::task(std::size_t event, std::string label, int threads) const {
  return make_task(study_, design_, scenario(event), spacing_, std::move(label), threads);
}

void DesignRun::set(std::size_t event, records::Simulation simulation) {
  simulations_[event] = std::move(simulation);
}

void DesignRun::fail(records::EvaluationRecord& record, const std::string& reason) const {
  record.ok = false;
  record.reason = reason;
  record.constraints = score_expressions(study_, design_);
}

namespace {

/// Adds an event's warnings; of a key that is there already, the one farther beyond its limit.
void join(std::vector<solver::Warning>& all, const records::ScenarioRecord& event) {
  for (solver::Warning warning : event.warnings) {
    if (!event.name.empty()) warning.text += " (" + event.name + ")";
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const auto& one) { return one.key == warning.key; });
    if (known == all.end()) {
      all.push_back(std::move(warning));
    } else if (std::abs(warning.value - warning.limit) > std::abs(known->value - known->limit)) {
      *known = std::move(warning);
    }
  }
}

}  // namespace

records::EvaluationRecord DesignRun::record() const {
  records::EvaluationRecord record;
  record.design = design_;
  record.options = designs::option_names(study_, design_);
  record.spacing = spacing_;
  std::string problem;
  std::vector<Event> events;
  for (std::size_t k = 0; k < size(); ++k) {
    records::ScenarioRecord one = records::scenario_record(scenario(k), simulations_[k].value());
    record.wall_time += one.wall_time;
    record.cpu_time += one.cpu_time;
    record.particle_steps += one.particle_steps;
    if (scenario(k) == nullptr) {
      record.stop_reason = one.stop_reason;
      record.case_hash = one.case_hash;
    }
    if (!one.ok && problem.empty()) {
      problem = scenario(k) == nullptr ? one.reason : "scenario " + one.name + ": " + one.reason;
    }
    join(record.warnings, one);
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

Json DesignRun::report(const records::ProgramInfo& program) const {
  Json report;
  report["provenance"] = records::study_provenance(study_, program);
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
                                    double spacing, SimulationService& service) {
  DesignRun run(study, design, spacing);
  const int threads = threads_each(run.size(), service.places());
  bool cancelled = false;
  const auto begin = [&](std::size_t event) -> std::optional<SimulationTask> {
    try {
      return run.task(event, study.name, threads);
    } catch (const designs::InputError& error) {
      run.set(event, impossible_scene(error.what()));
      return std::nullopt;
    }
  };
  const auto end = [&](std::size_t event, records::Simulation simulation) {
    if (simulation.cancelled) cancelled = true;
    run.set(event, std::move(simulation));
  };
  simulate_in_order(service, run.size(), begin, end, [&] { return cancelled; });
  if (cancelled) return std::nullopt;
  return run;
}

}  // namespace parapet::study
