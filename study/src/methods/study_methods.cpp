#include "study_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bayesian_source.hpp"
#include "evaluation_pool.hpp"
#include "experiment_source.hpp"
#include "nlopt_source.hpp"
#include "parapet/study/scoring.hpp"
#include "scalarized.hpp"

namespace parapet::study {
namespace {

using optimizer::Termination;

StudySummary interrupted() {
  StudySummary summary;
  summary.state = StudyState::interrupted;
  summary.termination = optimizer::to_string(Termination::cancelled);
  summary.message = "interrupted; the same command resumes";
  return summary;
}

StudySummary ended(StudyState state, const std::string& termination, const std::string& message) {
  StudySummary summary;
  summary.state = state;
  summary.termination = termination;
  summary.message = message;
  return summary;
}

/// Set when nothing was evaluated with success: then the study failed, however it ended.
std::optional<StudySummary> all_failed(const StudyContext& context) {
  const auto& records = context.folder.log().records();
  const bool any = std::any_of(records.begin(), records.end(),
                               [](const records::EvaluationRecord& r) { return r.ok; });
  if (any || records.empty()) return std::nullopt;
  return ended(StudyState::failed, optimizer::to_string(Termination::failed),
               fmt::format("all {} designs failed; the first one: {}", records.size(),
                           records.front().reason));
}

PoolLimits pool_limits(const designs::Method& method) {
  return {.max_cpu_time = method.max_cpu_time_s, .max_time = method.max_time_s};
}

/// What ended the pool, unless it was its source.
std::optional<StudySummary> pool_summary(PoolEnd end, const designs::Method& method) {
  switch (end) {
    case PoolEnd::cancelled:
      return interrupted();
    case PoolEnd::cpu_time:
      return ended(StudyState::done, "cpu_time_limit",
                   fmt::format("the processor time of {:g} s is used up", method.max_cpu_time_s));
    case PoolEnd::time:
      return ended(StudyState::done, optimizer::to_string(Termination::time_limit),
                   fmt::format("the time of {:g} s is up", method.max_time_s));
    case PoolEnd::source_ended:
      break;
  }
  return std::nullopt;
}

StudySummary stop_summary(bayesian::StopReason reason, const designs::Method& method) {
  using bayesian::StopReason;
  const auto done = [&](Termination termination, const std::string& message) {
    return ended(StudyState::done, optimizer::to_string(termination), message);
  };
  switch (reason) {
    case StopReason::budget:
      return done(Termination::budget,
                  fmt::format("the budget of {} evaluations is used up", method.max_evaluations));
    case StopReason::seconds:
      return done(Termination::budget, "the budget of processor time is used up");
    case StopReason::stagnation:
      return done(Termination::converged, "the last evaluations brought no gain");
    case StopReason::small_gain:
      return done(Termination::converged, "the expected gain of another evaluation is small");
    case StopReason::exhausted:
      return done(Termination::converged, "every design that differs has been evaluated");
    case StopReason::no_allowed_design:
      return ended(StudyState::failed, optimizer::to_string(Termination::no_feasible_start),
                   "no design satisfies the constraints that need no simulation");
    case StopReason::none:
      break;
  }
  return done(Termination::converged, "nothing more to evaluate");
}

AnswerOrder answer_order(const designs::Method& method, int jobs) {
  if (method.repeatable) return AnswerOrder::by_question;
  return jobs <= 1 ? AnswerOrder::by_log : AnswerOrder::as_they_come;
}

/// The search itself proposes only designs that are allowed.
void log_refused_starts(const StudyContext& context) {
  for (const designs::Design& start : context.study.method.starts) {
    const auto g = expression_violations(context.study, start);
    const bool refused =
        std::any_of(g.begin(), g.end(), [](double v) { return v > feasibility_tolerance; });
    if (refused) store_refused(context, start);
  }
}

StudySummary search_bayesian(const StudyContext& context, OutputWriter& writer) {
  const designs::Method& method = context.study.method;
  log_refused_starts(context);
  const SearchProblem problem = make_search_problem(context.study);
  bayesian::SearchOptions options = make_search_options(context.study);
  const records::BegunWith begun = context.folder.begun_with();
  options.planned_evaluations = begun.max_evaluations;
  bayesian::Search search(problem.problem, options);
  writer.attach(problem, search);
  const std::size_t events = std::max<std::size_t>(1, context.study.scenarios.size());
  BayesianSource source(context, problem, search, answer_order(method, context.service.places()),
                        open_questions(begun.jobs, events));
  EvaluationPool pool(context, source, pool_limits(method), [&] { writer.search_told(); });
  const PoolEnd end = pool.run();
  source.finish();
  auto summary = pool_summary(end, method);
  if (!summary) summary = all_failed(context);
  if (!summary) summary = stop_summary(search.stop_reason(), method);
  // The search and its problem end here: what they know is written now.
  return writer.end(*std::move(summary));
}

StudySummary search_experiments(const StudyContext& context) {
  Experiments experiments = lay_out_experiments(context.study);
  const std::size_t count = experiments.designs.size();
  const int refused = experiments.refused;
  for (const designs::Design& design : experiments.refused_designs) store_refused(context, design);
  if (count == 0) {
    StudySummary summary =
        ended(StudyState::failed, optimizer::to_string(Termination::no_feasible_start),
              "no design satisfies the constraints that need no simulation");
    summary.rejected = refused;
    return summary;
  }
  ExperimentSource source(context.study, std::move(experiments));
  EvaluationPool pool(context, source, pool_limits(context.study.method), {});
  auto summary = pool_summary(pool.run(), context.study.method);
  if (!summary) summary = all_failed(context);
  if (!summary) {
    summary = ended(StudyState::done, optimizer::to_string(Termination::budget),
                    fmt::format("all {} designs of the list are evaluated", count));
  }
  summary->rejected = refused;
  return *summary;
}

StudySummary summary_of(const optimizer::OptimizeResult& result) {
  if (result.termination == Termination::cancelled) return interrupted();
  const bool failed = result.termination == Termination::failed ||
                      result.termination == Termination::no_feasible_start;
  return ended(failed ? StudyState::failed : StudyState::done,
               optimizer::to_string(result.termination), result.message);
}

StudySummary search_nlopt(const StudyContext& context) {
  const designs::StudySpec& study = context.study;
  const bool scalarized = designs::search_kind(study) == designs::SearchKind::scalarized;
  NloptSource source(context, [&](BlockingEvaluator& evaluator) {
    return scalarized ? optimize_scalarized(study, evaluator)
                      : optimize_weighted_sum(study, evaluator);
  });
  // The optimiser watches max_time_s itself.
  EvaluationPool pool(context, source, {.max_cpu_time = study.method.max_cpu_time_s}, {});
  const PoolEnd end = pool.run();
  const optimizer::OptimizeResult result = source.finish();
  StudySummary summary = pool_summary(end, study.method).value_or(summary_of(result));
  summary.cache_hits = result.cache_hits;
  summary.rejected = result.rejected;
  return summary;
}

}  // namespace

StudySummary search_study(const StudyContext& context, OutputWriter& writer) {
  switch (designs::search_kind(context.study)) {
    case designs::SearchKind::bayesian:
      return search_bayesian(context, writer);
    case designs::SearchKind::experiments:
      return writer.end(search_experiments(context));
    case designs::SearchKind::scalarized:
    case designs::SearchKind::weighted_sum:
      break;
  }
  return writer.end(search_nlopt(context));
}

}  // namespace parapet::study
