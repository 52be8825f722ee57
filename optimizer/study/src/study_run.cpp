#include "parapet/study/study_run.hpp"

#include <chrono>

#include "parapet/optimizer/optimize.hpp"
#include "parapet/reports/atomic_file.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/study_evaluator.hpp"
#include "parapet/study/study_folder.hpp"

namespace parapet::study {
namespace {

using Clock = std::chrono::steady_clock;
using reports::EvaluationRecord;

/// Lower objective first; equal ones by their id, so that the order in the log does not matter.
bool better(const EvaluationRecord& a, const EvaluationRecord& b) {
  if (*a.objective_scalar != *b.objective_scalar) return *a.objective_scalar < *b.objective_scalar;
  return a.id < b.id;
}

std::optional<EvaluationRecord> best_of(const std::vector<EvaluationRecord>& records,
                                        bool only_starts) {
  const EvaluationRecord* best = nullptr;
  for (const EvaluationRecord& record : records) {
    if (!record.feasible || !record.objective_scalar) continue;
    if (only_starts && record.stage != "start") continue;
    if (best == nullptr || better(record, *best)) best = &record;
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

/// Keeps summary.json in step with the log.
class SummaryWriter {
 public:
  SummaryWriter(const designs::StudySpec& study, const StudyFolder& folder)
      : study_(study), folder_(folder), at_begin_(folder.log().records().size()) {}

  StudySummary write(StudySummary summary) const {
    const auto& records = folder_.log().records();
    summary.evaluations = static_cast<int>(records.size());
    summary.simulated = static_cast<int>(records.size() - at_begin_);
    summary.best = best_of(records, false);
    summary.starting_best = best_of(records, true);
    summary.elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
    folder_.write_summary(to_json(summary, study_));
    return summary;
  }

 private:
  const designs::StudySpec& study_;
  const StudyFolder& folder_;
  std::size_t at_begin_;
  Clock::time_point begin_ = Clock::now();
};

StudySummary summary_of(const optimizer::OptimizeResult& result, bool interrupted) {
  StudySummary summary;
  summary.cache_hits = result.cache_hits;
  summary.rejected = result.rejected;
  using optimizer::Termination;
  if (interrupted || result.termination == Termination::cancelled) {
    summary.state = StudyState::interrupted;
    summary.termination = optimizer::to_string(Termination::cancelled);
    summary.message = "interrupted; the same command resumes";
    return summary;
  }
  const bool failed = result.termination == Termination::failed ||
                      result.termination == Termination::no_feasible_start;
  summary.state = failed ? StudyState::failed : StudyState::done;
  summary.termination = optimizer::to_string(result.termination);
  summary.message = result.message;
  return summary;
}

/// The disk may be full, and then this does not work either: the exception itself says it all.
void try_to_say_failed(const SummaryWriter& writer, const std::string& why) {
  StudySummary summary;
  summary.state = StudyState::failed;
  summary.termination = optimizer::to_string(optimizer::Termination::failed);
  summary.message = why;
  try {
    writer.write(summary);
  } catch (const reports::FileError&) {
  }
}

}  // namespace

StudySummary run_study(const designs::StudySpec& study, const StudyRunOptions& options) {
  if (auto issues = method_issues(study); !issues.empty()) {
    throw designs::InputError(std::move(issues));
  }
  StudyFolder folder(options.folder, study, options.program);
  if (options.hooks.on_message) {
    for (const std::string& note : folder.notes()) options.hooks.on_message(note);
  }
  const SummaryWriter writer(study, folder);
  writer.write({});
  Hooks hooks = options.hooks;
  hooks.on_evaluated = [&](const EvaluationRecord& record, bool from_log) {
    if (!from_log) writer.write({});
    if (options.hooks.on_evaluated) options.hooks.on_evaluated(record, from_log);
  };
  StudyEvaluator evaluator(study, folder, options.program, options.jobs, hooks);
  optimizer::Problem problem = make_problem(study);
  problem.evaluate = [&](const std::vector<double>& x) {
    return evaluator.evaluate({x}, "search").front();
  };
  problem.evaluate_batch = [&](const std::vector<std::vector<double>>& xs) {
    return evaluator.evaluate(xs, "start");
  };
  optimizer::Options search = make_options(study);
  search.cancelled = [&] { return evaluator.stopped(); };
  const optimizer::OptimizeResult result = optimizer::optimize(problem, search);
  try {
    evaluator.throw_if_failed();
  } catch (const std::exception& error) {
    try_to_say_failed(writer, error.what());
    throw;
  }
  return writer.write(summary_of(result, evaluator.stopped()));
}

}  // namespace parapet::study
