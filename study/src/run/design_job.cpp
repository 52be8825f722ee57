#include <utility>

#include "parapet/study/scoring.hpp"
#include "parapet/study/simulator.hpp"
#include "parapet/study/study_context.hpp"

namespace parapet::study {

void store_refused(const StudyContext& context, designs::Design design) {
  records::RefusedDesign refused;
  refused.options = designs::option_names(context.study, design);
  refused.constraints = score_expressions(context.study, design);
  for (const records::ConstraintRecord& constraint : refused.constraints) {
    if (constraint.satisfied) continue;
    refused.reason += (refused.reason.empty() ? "violates " : ", ") + constraint.name;
  }
  refused.design = std::move(design);
  records::set_program(refused, context.program);
  context.folder.store(std::move(refused));
}

DesignJob::DesignJob(const StudyContext& context, std::string id, std::string stage,
                     designs::Design design, double spacing)
    : context_(context),
      id_(std::move(id)),
      stage_(std::move(stage)),
      run_(context.study, std::move(design), spacing),
      open_(run_.size()) {}

std::string DesignJob::label(std::size_t event) const {
  const designs::Scenario* scenario = run_.scenario(event);
  return scenario == nullptr ? id_ : id_ + " " + scenario->name;
}

std::optional<SimulationTask> DesignJob::begin(std::size_t event, int threads) {
  const designs::Scenario* scenario = run_.scenario(event);
  const std::string name = scenario == nullptr ? "" : scenario->name;
  const auto* known = context_.folder.unfinished(run_.design(), run_.spacing(), name);
  if (known != nullptr) {
    keep(event, *known);
    return std::nullopt;
  }
  try {
    return run_.task(event, label(event), threads);
  } catch (const designs::InputError& error) {
    end(event, impossible_scene(error.what()));
    return std::nullopt;
  }
}

void DesignJob::end(std::size_t event, records::Simulation simulation) {
  if (context_.hooks.on_simulation_ended) context_.hooks.on_simulation_ended(label(event));
  if (!simulation.cancelled) keep(event, std::move(simulation));
}

void DesignJob::keep(std::size_t event, records::Simulation simulation) {
  run_.set(event, std::move(simulation));
  --open_;
}

/// Also what was known is written: the design may have another id now.
void DesignJob::write_event(std::size_t event) const {
  const designs::Scenario* scenario = run_.scenario(event);
  if (scenario == nullptr || !run_.simulation(event)) return;
  context_.folder.store_simulation(id_, run_.design(), run_.spacing(), *scenario,
                                   run_.simulation(event).value(),
                                   records::study_provenance(context_.study, context_.program));
}

void DesignJob::lose(std::size_t event) {
  if (run_.simulation(event)) ++open_;
}

void DesignJob::wait_on_disk() {
  if (run_.scenario(0) != nullptr || waits_) return;
  context_.folder.store_simulation(id_, run_.design(), run_.spacing(), designs::Scenario{},
                                   run_.simulation(0).value(),
                                   records::study_provenance(context_.study, context_.program));
  waits_ = true;
}

const records::EvaluationRecord& DesignJob::record() {
  if (!record_) {
    record_ = run_.record();
    record_->id = id_;
    record_->stage = stage_;
    records::set_program(*record_, context_.program);
  }
  return *record_;
}

void DesignJob::write_report() {
  context_.folder.store_report(record(), run_.report(context_.program));
}

void DesignJob::logged() const {
  if (run_.scenario(0) == nullptr) context_.folder.discard_simulation(id_);
}

}  // namespace parapet::study
