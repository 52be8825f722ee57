#include <utility>

#include "parapet/study/study_context.hpp"

namespace parapet::study {

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

DesignJob::Outcome DesignJob::simulate(std::size_t event, int threads) {
  const designs::Scenario* scenario = run_.scenario(event);
  const records::Simulation* known =
      scenario == nullptr
          ? nullptr
          : context_.folder.unfinished(run_.design(), run_.spacing(), scenario->name);
  const std::string label_text = label(event);
  if (known != nullptr) {
    run_.set(event, *known);
  } else {
    solver::Callbacks callbacks;
    callbacks.on_progress = [&](const solver::Progress& progress) {
      if (context_.hooks.on_simulation) context_.hooks.on_simulation(label_text, progress);
      return !context_.cancelled();
    };
    records::Simulation simulation = context_.simulator({.study = context_.study,
                                                         .design = run_.design(),
                                                         .scenario = scenario,
                                                         .spacing = run_.spacing(),
                                                         .threads = threads,
                                                         .callbacks = callbacks});
    if (context_.hooks.on_simulation_ended) context_.hooks.on_simulation_ended(label_text);
    if (simulation.cancelled) return Outcome::cancelled;
    run_.set(event, std::move(simulation));
  }
  // Also what was known is written: the design may have another id now.
  if (scenario != nullptr) {
    context_.folder.store_simulation(id_, run_.design(), run_.spacing(), *scenario, event,
                                     run_.simulation(event).value(),
                                     records::study_provenance(context_.study, context_.program));
  }
  return open_.fetch_sub(1) == 1 ? Outcome::complete : Outcome::incomplete;
}

records::EvaluationRecord DesignJob::store() const {
  records::EvaluationRecord record = run_.record();
  record.id = id_;
  record.stage = stage_;
  context_.folder.store(record, run_.report(context_.program));
  return record;
}

}  // namespace parapet::study
