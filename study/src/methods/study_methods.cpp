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

/// All simulations are at the finest spacing: their number is their cost over that of the mean one.
std::size_t affordable_designs(const designs::StudySpec& study) {
  const double runs = study.method.max_finest_runs;
  if (runs <= 0.0) return 0;
  const double events = static_cast<double>(std::max<std::size_t>(1, study.scenarios.size()));
  constexpr double rounding = 1e-9;
  return static_cast<std::size_t>(runs / events * (1.0 + rounding));
}

std::string finest_runs_used(const designs::Method& method) {
  return fmt::format("the budget of {:g} finest runs is used up", method.max_finest_runs);
}

/// What ended the pool, unless it was its source.
std::optional<StudySummary> pool_summary(PoolEnd end, const designs::Method& method) {
  switch (end) {
    case PoolEnd::cancelled:
      return interrupted();
    case PoolEnd::cpu_time:
      return ended(StudyState::done, "cpu_time_limit",
                   fmt::format("the processor time of {:g} s is used up", method.max_cpu_time_s));
    case PoolEnd::designs:
      return ended(StudyState::done, optimizer::to_string(Termination::budget),
                   finest_runs_used(method));
    case PoolEnd::time:
      return ended(StudyState::done, optimizer::to_string(Termination::time_limit),
                   fmt::format("the time of {:g} s is up", method.max_time_s));
    case PoolEnd::source_ended:
      break;
  }
  return std::nullopt;
}

/// Why nothing could be simulated: only constraints that there are get the blame.
std::string no_allowed_design(const designs::StudySpec& study) {
  std::string formulas;
  for (const designs::Objective& objective : study.objectives) {
    if (!objective.is_of_design()) continue;
    formulas += (formulas.empty() ? "" : ", ") + objective_name(objective);
  }
  const std::string without_value = "has a value of the objective " + formulas;
  if (expression_limit_count(study) == 0) return "no design that was tried " + without_value;
  return "no design satisfies the constraints that need no simulation" +
         (formulas.empty() ? "" : ", or none of those that do " + without_value);
}

StudySummary stop_summary(bayesian::StopReason reason, const designs::StudySpec& study) {
  using bayesian::StopReason;
  const designs::Method& method = study.method;
  const auto done = [&](Termination termination, const std::string& message) {
    return ended(StudyState::done, optimizer::to_string(termination), message);
  };
  switch (reason) {
    case StopReason::budget:
      return done(Termination::budget,
                  fmt::format("the budget of {} evaluations is used up", method.max_evaluations));
    case StopReason::seconds:
      return done(Termination::budget, finest_runs_used(method));
    case StopReason::stagnation:
      return done(Termination::converged, "the last evaluations brought no gain");
    case StopReason::small_gain:
      return done(Termination::converged, "the expected gain of another evaluation is small");
    case StopReason::exhausted:
      return done(Termination::converged, "every design that differs has been evaluated");
    case StopReason::no_allowed_design:
      return ended(StudyState::failed, optimizer::to_string(Termination::no_feasible_start),
                   no_allowed_design(study));
    case StopReason::none:
      break;
  }
  return done(Termination::converged, "nothing more to evaluate");
}

AnswerOrder answer_order(const designs::Method& method, int jobs) {
  return method.repeatable || jobs <= 1 ? AnswerOrder::by_question : AnswerOrder::as_they_come;
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
  const std::size_t lag = method.repeatable ? open_questions(begun.jobs, events) : 1;
  BayesianSource source(context, problem, search, answer_order(method, context.service.places()),
                        lag);
  EvaluationPool pool(context, source, pool_limits(method), [&] { writer.search_told(); });
  const PoolEnd end = pool.run();
  source.finish();
  auto summary = pool_summary(end, method);
  if (!summary) summary = all_failed(context);
  if (!summary) summary = stop_summary(search.stop_reason(), context.study);
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
              no_allowed_design(context.study));
    summary.rejected = refused;
    return summary;
  }
  ExperimentSource source(context.study, std::move(experiments));
  PoolLimits limits = pool_limits(context.study.method);
  limits.max_designs = affordable_designs(context.study);
  EvaluationPool pool(context, source, limits, {});
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
  EvaluationPool pool(
      context, source,
      {.max_cpu_time = study.method.max_cpu_time_s, .max_designs = affordable_designs(study)}, {});
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
