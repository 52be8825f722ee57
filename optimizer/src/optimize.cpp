#include "parapet/optimizer/optimize.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "feasibility.hpp"
#include "search.hpp"
#include "starting_points.hpp"

namespace parapet::optimizer {
namespace {

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& s : sentences) text += (text.empty() ? "" : "; ") + s;
  return text;
}

/// The best feasible point so far, else the least violating one, in the unit box.
std::vector<double> search_start(const EvaluationLedger& ledger, const UnitBox& box) {
  std::optional<Point> point = best_feasible(ledger.history());
  if (!point) point = least_violating(ledger.history());
  return box.to_unit(point->x);
}

void evaluate_starts(const Problem& problem, const Options& options, UnitBox& box,
                     EvaluationLedger& ledger) {
  const auto starts = choose_starts(problem, options, box, ledger);
  if (starts.empty()) {
    throw StopSearch{Termination::no_feasible_start,
                     "no point of the box satisfies the constraints that need no evaluation; "
                     "20000 Sobol' points and searches from 64 of them found none"};
  }
  for (const auto& x : starts) box.remember(x);
  ledger.evaluate_starts(starts);
  if (!ledger.any_success()) {
    throw StopSearch{Termination::failed, "all " + std::to_string(ledger.evaluations()) +
                                              " starting points failed; the first one: " +
                                              ledger.history().front().evaluation.reason};
  }
}

/// Violation, then objective, of the best point so far.
std::pair<double, double> rank_of_best(const EvaluationLedger& ledger) {
  std::optional<Point> point = best_feasible(ledger.history());
  if (point) return {0.0, point->evaluation.objective};
  point = least_violating(ledger.history());
  return {violation(point->evaluation.constraints), point->evaluation.objective};
}

/// Runs the algorithm. Points that failed or were refused distort the models and simplices of the
/// local algorithms, and they may then settle anywhere; an end without any feasible point is not
/// trusted either. Such an end is taken back: the search goes on from the best point with half the
/// step, until that brings nothing twice.
SearchOutcome run_with_restarts(Search search, bool native, const UnitBox& box) {
  const EvaluationLedger& ledger = search.ledger;
  SearchOutcome outcome;
  for (int stagnations = 0; stagnations < 2;) {
    const int disturbances = ledger.failures() + ledger.rejected();
    const auto rank = rank_of_best(ledger);
    const auto start = search_start(ledger, box);
    outcome = native ? search_natively(search, start) : search_augmented(search, start);
    const auto reached = rank_of_best(ledger);
    const bool disturbed = ledger.failures() + ledger.rejected() > disturbances;
    const bool trusted = !disturbed && reached.first == 0.0;
    const double smallest_step = 4.0 * search.options.relative_tolerance;
    if (trusted || search.algorithm.info.global || search.initial_step <= smallest_step) break;
    stagnations = reached < rank ? 0 : stagnations + 1;
    search.initial_step = std::max(smallest_step, 0.5 * search.initial_step);
  }
  return outcome;
}

/// Runs the algorithm that the options ask for; the message says how it ended.
std::string search_from_best_start(const Problem& problem, const Options& options,
                                   const UnitBox& box, EvaluationLedger& ledger) {
  std::string unused;
  const AlgorithmEntry* algorithm = find_algorithm(options.algorithm, unused);
  const AlgorithmEntry* local =
      algorithm->needs_local ? find_algorithm(options.local_algorithm, unused) : nullptr;
  const std::string name = algorithm->info.name;
  const bool auglag = algorithm->nlopt_name.empty();
  if (auglag) std::swap(algorithm, local);
  const Search search{.ledger = ledger,
                      .options = options,
                      .algorithm = *algorithm,
                      .local = auglag ? nullptr : local,
                      .initial_step = options.initial_step,
                      .n_variables = static_cast<int>(problem.lower.size()),
                      .n_constraints = problem.n_constraints + problem.n_cheap_constraints};
  const bool native =
      search.n_constraints == 0 || (algorithm->info.inequality_constraints && !auglag);
  const SearchOutcome outcome = run_with_restarts(search, native, box);
  return name + (native ? "" : " (augmented Lagrangian)") +
         " ended by itself, NLopt: " + outcome.code;
}

}  // namespace

std::string to_string(Termination termination) {
  switch (termination) {
    case Termination::converged:
      return "converged";
    case Termination::budget:
      return "budget";
    case Termination::time_limit:
      return "time_limit";
    case Termination::cancelled:
      return "cancelled";
    case Termination::no_feasible_start:
      return "no_feasible_start";
    case Termination::failed:
      return "failed";
  }
  return "unknown";
}

OptimizeResult optimize(const Problem& problem, const Options& options) {
  if (const auto errors = problem_errors(problem, options); !errors.empty()) {
    throw std::invalid_argument(joined(errors));
  }
  UnitBox box(problem.lower, problem.upper);
  EvaluationLedger ledger(problem, options, box);
  OptimizeResult result;
  try {
    evaluate_starts(problem, options, box, ledger);
    result.message = search_from_best_start(problem, options, box, ledger);
    result.termination = Termination::converged;
  } catch (const StopSearch& stop) {
    result.termination = stop.termination;
    result.message = stop.message;
  } catch (const NloptFailure& failure) {
    result.termination = Termination::failed;
    result.message = failure.what();
  }
  result.best = best_feasible(ledger.history());
  if (!result.best && ledger.any_success()) {
    result.best_infeasible = least_violating(ledger.history());
    result.message += "; no feasible point was found";
  }
  result.evaluations = ledger.evaluations();
  result.cache_hits = ledger.cache_hits();
  result.rejected = ledger.rejected();
  result.history = ledger.history();
  return result;
}

}  // namespace parapet::optimizer
