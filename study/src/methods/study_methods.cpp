#include "study_methods.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parapet/optimizer/optimize.hpp"
#include "parapet/study/experiments.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/study_evaluator.hpp"
#include "scalarized.hpp"
#include "search_source.hpp"

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

StudySummary search_bayesian(const StudyContext& context, int jobs, OutputWriter& writer) {
  const designs::Method& method = context.study.method;
  const SearchProblem problem = make_search_problem(context.study);
  bayesian::SearchOptions options = make_search_options(context.study);
  const records::BegunWith begun = context.folder.begun_with();
  options.planned_evaluations = begun.max_evaluations;
  bayesian::Search search(problem.problem, options);
  writer.attach(problem, search);
  const std::size_t events = std::max<std::size_t>(1, context.study.scenarios.size());
  SearchSource source(context, problem, search, answer_order(method, jobs),
                      open_questions(begun.jobs, events));
  EvaluationPool pool(context, source, jobs, pool_limits(method), [&] { writer.search_told(); });
  const PoolEnd end = pool.run();
  source.finish();
  auto summary = pool_summary(end, method);
  if (!summary) summary = all_failed(context);
  if (!summary) summary = stop_summary(search.stop_reason(), method);
  // The search and its problem end here: what they know is written now.
  return writer.end(*std::move(summary));
}

/// A list of designs, in order.
class ListSource : public DesignSource {
 public:
  ListSource(const designs::StudySpec& study, Experiments experiments)
      : spacing_(designs::finest_spacing(study)), experiments_(std::move(experiments)) {}

  std::optional<Proposal> next() override {
    if (next_ >= experiments_.designs.size()) return std::nullopt;
    Proposal proposal;
    proposal.stage = next_ < experiments_.n_starts ? "start" : "sample";
    proposal.design = experiments_.designs[next_++];
    proposal.spacing = spacing_;
    return proposal;
  }
  void answered(std::size_t, const records::EvaluationRecord&) override {}

 private:
  double spacing_;
  Experiments experiments_;
  std::size_t next_ = 0;
};

StudySummary search_experiments(const StudyContext& context, int jobs) {
  Experiments experiments = lay_out_experiments(context.study);
  const std::size_t count = experiments.designs.size();
  const int refused = experiments.refused;
  if (count == 0) {
    StudySummary summary =
        ended(StudyState::failed, optimizer::to_string(Termination::no_feasible_start),
              "no design satisfies the constraints that need no simulation");
    summary.rejected = refused;
    return summary;
  }
  ListSource source(context.study, std::move(experiments));
  EvaluationPool pool(context, source, jobs, pool_limits(context.study.method), {});
  auto summary = pool_summary(pool.run(), context.study.method);
  if (!summary) summary = all_failed(context);
  if (!summary) {
    summary = ended(StudyState::done, optimizer::to_string(Termination::budget),
                    fmt::format("all {} designs of the list are evaluated", count));
  }
  summary->rejected = refused;
  return *summary;
}

StudySummary summary_of(const optimizer::OptimizeResult& result, bool interruption) {
  StudySummary summary;
  if (interruption || result.termination == Termination::cancelled) {
    summary = interrupted();
  } else {
    const bool failed = result.termination == Termination::failed ||
                        result.termination == Termination::no_feasible_start;
    summary = ended(failed ? StudyState::failed : StudyState::done,
                    optimizer::to_string(result.termination), result.message);
  }
  summary.cache_hits = result.cache_hits;
  summary.rejected = result.rejected;
  return summary;
}

optimizer::OptimizeResult optimize_weighted_sum(const StudyContext& context,
                                                StudyEvaluator& evaluator) {
  optimizer::Problem problem = make_problem(context.study);
  const Scalarizer scalarizer = weighted_sum(context.study);
  problem.evaluate = [&](const std::vector<double>& x) {
    return evaluator.evaluate({x}, "search", scalarizer).front();
  };
  problem.evaluate_batch = [&](const std::vector<std::vector<double>>& xs) {
    return evaluator.evaluate(xs, "start", scalarizer);
  };
  optimizer::Options options = make_options(context.study);
  options.cancelled = [&] { return evaluator.stopped(); };
  return optimizer::optimize(problem, options);
}

StudySummary search_nlopt(const StudyContext& context, int jobs) {
  StudyEvaluator evaluator(context, jobs);
  const optimizer::OptimizeResult result =
      designs::search_kind(context.study) == designs::SearchKind::scalarized
          ? optimize_scalarized(context, evaluator)
          : optimize_weighted_sum(context, evaluator);
  evaluator.throw_if_failed();
  StudySummary summary = summary_of(result, evaluator.stopped());
  if (evaluator.out_of_cpu_time() && !context.cancelled()) {
    summary = *pool_summary(PoolEnd::cpu_time, context.study.method);
    summary.cache_hits = result.cache_hits;
    summary.rejected = result.rejected;
  }
  return summary;
}

}  // namespace

StudySummary search_study(const StudyContext& context, int jobs, OutputWriter& writer) {
  switch (designs::search_kind(context.study)) {
    case designs::SearchKind::bayesian:
      return search_bayesian(context, jobs, writer);
    case designs::SearchKind::experiments:
      return writer.end(search_experiments(context, jobs));
    case designs::SearchKind::scalarized:
    case designs::SearchKind::weighted_sum:
      break;
  }
  return writer.end(search_nlopt(context, jobs));
}

}  // namespace parapet::study
