#include "blocking_evaluator.hpp"

#include <algorithm>

#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::study {

Scalarizer weighted_sum(const designs::StudySpec& study) {
  return [&study](const records::EvaluationRecord& record) {
    // From the metrics, also right after the simulation: a replay takes the same way.
    const Score scored = score(study, record.design, events_of(record));
    optimizer::Evaluation evaluation;
    evaluation.ok = scored.objective_scalar.has_value();
    evaluation.reason = scored.problem;
    evaluation.objective = scored.objective_scalar.value_or(0.0);
    evaluation.constraints = scored.metric_violations;
    return evaluation;
  };
}

std::vector<optimizer::Evaluation> BlockingEvaluator::evaluate(
    const std::vector<std::vector<double>>& xs, const std::string& stage,
    const Scalarizer& scalarizer) {
  const double spacing = designs::finest_spacing(context_.study);
  std::vector<designs::Design> designs;
  std::vector<Proposal> batch;
  for (const auto& x : xs) {
    designs.push_back(to_design(context_.study, x));
    const designs::Design& design = designs.back();
    // Integers are rounded, so that two points of a batch may be one design.
    const bool repeated = std::any_of(
        batch.begin(), batch.end(), [&](const Proposal& other) { return other.design == design; });
    if (repeated) continue;
    if (known_.try_emplace(design).second) asked_.push_back(design);
    batch.push_back({.stage = stage, .design = design, .spacing = spacing});
  }
  const Handover::Answers answers = handover_.ask(batch);
  for (std::size_t k = 0; k < answers.size(); ++k) {
    if (answers[k]) known_[batch[k].design] = answers[k];
  }
  std::vector<optimizer::Evaluation> evaluations;
  for (const designs::Design& design : designs) evaluations.push_back(answer(design, scalarizer));
  return evaluations;
}

optimizer::Evaluation BlockingEvaluator::answer(const designs::Design& design,
                                                const Scalarizer& scalarizer) const {
  optimizer::Evaluation evaluation;
  const auto& record = known_.at(design);
  if (!record) {
    evaluation.reason = "not evaluated: the study was stopped";
    return evaluation;
  }
  if (!record->ok) {
    evaluation.reason = record->reason;
    return evaluation;
  }
  return scalarizer(*record);
}

void BlockingEvaluator::refused(const std::vector<double>& x) {
  const std::scoped_lock lock(mutex_);
  if (refused_.size() < records::most_refused_designs) {
    refused_.push_back(to_design(context_.study, x));
  }
}

void BlockingEvaluator::log_refused() {
  std::vector<designs::Design> designs;
  {
    const std::scoped_lock lock(mutex_);
    designs.swap(refused_);
  }
  for (designs::Design& design : designs) store_refused(context_, std::move(design));
}

std::vector<records::EvaluationRecord> BlockingEvaluator::records() const {
  std::vector<records::EvaluationRecord> records;
  for (const designs::Design& design : asked_) {
    if (const auto& record = known_.at(design)) records.push_back(*record);
  }
  return records;
}

}  // namespace parapet::study
