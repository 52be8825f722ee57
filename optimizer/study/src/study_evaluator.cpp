#include "parapet/study/study_evaluator.hpp"

#include "parapet/study/design_run.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/side_by_side.hpp"

namespace parapet::study {

StudyEvaluator::StudyEvaluator(const designs::StudySpec& study, StudyFolder& folder,
                               const reports::ProgramInfo& program, int jobs, const Hooks& hooks)
    : study_(study), folder_(folder), program_(program), jobs_(jobs), hooks_(hooks) {}

bool StudyEvaluator::stopped() const {
  return failure_ || cancelled_ || (hooks_.cancelled && hooks_.cancelled());
}

void StudyEvaluator::throw_if_failed() const {
  if (failure_) std::rethrow_exception(failure_);
}

StudyEvaluator::Question StudyEvaluator::pose(const std::vector<double>& x) {
  Question question{.id = "", .design = to_design(study_, x)};
  ++questions_;
  if (const auto* known = folder_.log().find(question.design)) {
    question.id = known->id;
    return question;
  }
  int number = questions_;
  while (folder_.log().has_id(reports::evaluation_id(number)) || ids_given_.count(number) != 0) {
    ++number;
  }
  ids_given_.insert(number);
  question.id = reports::evaluation_id(number);
  return question;
}

std::vector<optimizer::Evaluation> StudyEvaluator::evaluate(
    const std::vector<std::vector<double>>& xs, const std::string& stage) {
  std::vector<Question> questions;
  std::vector<std::size_t> unknown;
  for (const auto& x : xs) {
    questions.push_back(pose(x));
    if (const auto* known = folder_.log().find(questions.back().design)) {
      ++answered_from_log_;
      if (hooks_.on_evaluated) hooks_.on_evaluated(*known, true);
    } else {
      unknown.push_back(questions.size() - 1);
    }
  }
  try {
    run_side_by_side(
        unknown.size(), jobs_,
        [&](std::size_t k, int threads) { simulate(questions[unknown[k]], stage, threads); },
        [this] { return stopped(); });
  } catch (...) {
    failure_ = std::current_exception();
  }
  std::vector<optimizer::Evaluation> answers;
  for (const Question& question : questions) answers.push_back(answer(question.design));
  return answers;
}

void StudyEvaluator::simulate(const Question& question, const std::string& stage, int threads) {
  solver::Callbacks callbacks;
  callbacks.on_progress = [&](const solver::Progress& progress) {
    if (hooks_.on_simulation) hooks_.on_simulation(question.id, progress);
    return !(hooks_.cancelled && hooks_.cancelled());
  };
  DesignRun run = run_design(study_, question.design, program_, threads, callbacks);
  if (run.cancelled) {
    cancelled_ = true;
    return;
  }
  run.record.id = question.id;
  run.record.stage = stage;
  const std::scoped_lock lock(mutex_);
  folder_.store(run.record, run.report);
  if (hooks_.on_evaluated) hooks_.on_evaluated(run.record, false);
}

optimizer::Evaluation StudyEvaluator::answer(const designs::Design& design) const {
  optimizer::Evaluation evaluation;
  const reports::EvaluationRecord* record = folder_.log().find(design);
  if (record == nullptr) {
    evaluation.reason = "not evaluated: the study was stopped";
    return evaluation;
  }
  if (!record->ok) {
    evaluation.reason = record->reason;
    return evaluation;
  }
  // From the metrics, also right after the simulation: a replay takes the same way.
  const Score scored = score(study_, design, record->metrics);
  evaluation.ok = scored.objective_scalar.has_value();
  evaluation.reason = scored.problem;
  evaluation.objective = scored.objective_scalar.value_or(0.0);
  evaluation.constraints = scored.metric_violations;
  return evaluation;
}

}  // namespace parapet::study
