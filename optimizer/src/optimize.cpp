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

/// Runs the algorithm from the best start; the message says how it ended.
std::string search_from(const std::vector<double>& start, const Problem& problem,
                        const Options& options, EvaluationLedger& ledger) {
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
                      .n_variables = static_cast<int>(problem.lower.size()),
                      .n_constraints = problem.n_constraints + problem.n_cheap_constraints};
  const bool native =
      search.n_constraints == 0 || (algorithm->info.inequality_constraints && !auglag);
  const SearchOutcome outcome =
      native ? search_natively(search, start) : search_augmented(search, start);
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
    result.message = search_from(search_start(ledger, box), problem, options, ledger);
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
