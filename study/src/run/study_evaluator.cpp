#include "parapet/study/study_evaluator.hpp"

#include <algorithm>
#include <utility>

#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/side_by_side.hpp"

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

StudyEvaluator::StudyEvaluator(const StudyContext& context, int jobs)
    : context_(context), jobs_(jobs) {}

bool StudyEvaluator::stopped() const {
  return failure_ || cancelled_ || out_of_cpu_time_ || context_.cancelled();
}

void StudyEvaluator::throw_if_failed() const {
  if (failure_) std::rethrow_exception(failure_);
}

bool StudyEvaluator::cpu_time_left() {
  const double most = context_.study.method.max_cpu_time_s;
  double spent = 0.0;
  for (const auto& record : context_.folder.log().records()) spent += record.cpu_time;
  out_of_cpu_time_ = most > 0.0 && spent >= most;
  return !out_of_cpu_time_;
}

std::unique_ptr<DesignJob> StudyEvaluator::pose(const designs::Design& design,
                                                const std::string& stage) {
  ++questions_;
  if (asked_set_.insert(design).second) asked_.push_back(design);
  const double spacing = designs::finest_spacing(context_.study);
  if (const auto* known = context_.folder.log().find(design, spacing)) {
    if (context_.hooks.on_evaluated) context_.hooks.on_evaluated(*known, true);
    return nullptr;
  }
  if (!cpu_time_left()) return nullptr;
  int number = questions_;
  while (ids_given_.count(number) != 0 ||
         !context_.folder.id_is_free(records::evaluation_id(number), design, spacing)) {
    ++number;
  }
  ids_given_.insert(number);
  return std::make_unique<DesignJob>(context_, records::evaluation_id(number), stage, design,
                                     spacing);
}

std::vector<optimizer::Evaluation> StudyEvaluator::evaluate(
    const std::vector<std::vector<double>>& xs, const std::string& stage,
    const Scalarizer& scalarizer) {
  std::vector<designs::Design> designs;
  std::vector<std::unique_ptr<DesignJob>> unknown;
  for (const auto& x : xs) {
    designs::Design design = to_design(context_.study, x);
    // Integers are rounded, so that two points of a batch may be one design.
    const bool repeated = std::find(designs.begin(), designs.end(), design) != designs.end();
    designs.push_back(std::move(design));
    if (repeated) continue;
    if (auto job = pose(designs.back(), stage)) unknown.push_back(std::move(job));
  }
  try {
    simulate(unknown);
  } catch (...) {
    failure_ = std::current_exception();
  }
  std::vector<optimizer::Evaluation> answers;
  for (const designs::Design& design : designs) answers.push_back(answer(design, scalarizer));
  return answers;
}

void StudyEvaluator::simulate(const std::vector<std::unique_ptr<DesignJob>>& jobs) {
  std::vector<std::pair<DesignJob*, std::size_t>> events;
  for (const auto& job : jobs) {
    for (std::size_t event = 0; event < job->size(); ++event) events.emplace_back(job.get(), event);
  }
  run_side_by_side(
      events.size(), jobs_,
      [&](std::size_t k, int threads) {
        const auto [job, event] = events[k];
        const DesignJob::Outcome outcome = job->simulate(event, threads);
        if (outcome == DesignJob::Outcome::cancelled) cancelled_ = true;
        if (outcome != DesignJob::Outcome::complete) return;
        const std::scoped_lock lock(mutex_);
        const records::EvaluationRecord record = job->store();
        if (context_.hooks.on_evaluated) context_.hooks.on_evaluated(record, false);
      },
      [this] { return stopped(); });
}

optimizer::Evaluation StudyEvaluator::answer(const designs::Design& design,
                                             const Scalarizer& scalarizer) const {
  optimizer::Evaluation evaluation;
  const auto* record = context_.folder.log().find(design, designs::finest_spacing(context_.study));
  if (record == nullptr) {
    evaluation.reason = "not evaluated: the study was stopped";
    return evaluation;
  }
  if (!record->ok) {
    evaluation.reason = record->reason;
    return evaluation;
  }
  return scalarizer(*record);
}

}  // namespace parapet::study
