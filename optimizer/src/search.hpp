/// The two ways to search under constraints, and what they share.
#pragma once

#include <string>
#include <vector>

#include "algorithm_table.hpp"
#include "evaluation_ledger.hpp"
#include "nlopt_adapter.hpp"

namespace parapet::optimizer {

struct Search {
  EvaluationLedger& ledger;
  const Options& options;
  const AlgorithmEntry& algorithm;  ///< the one that NLopt runs
  const AlgorithmEntry* local;      ///< MLSL's local algorithm, else null
  double initial_step;              ///< share of the range
  int n_variables;
  int n_constraints;  ///< of a Reply: cheap ones and those of the evaluator
};

/// A request with everything that does not change during a search.
SearchRequest base_request(const Search& search, const std::vector<double>& start);

/// Hands the constraints, if any, to an algorithm that has them itself. A local algorithm that
/// ends slightly outside (COBYLA does: its linear models cut curved constraints short) is run again
/// from there, with the constraints tightened by what they were exceeded.
/// @throws StopSearch at a limit, NloptFailure when NLopt fails.
SearchOutcome search_natively(const Search& search, const std::vector<double>& start);

/// Powell-Hestenes-Rockafellar augmented Lagrangian (Birgin and Martinez, Optim. Methods Softw. 23
/// (2008) 177-195) around an algorithm that knows only bounds:
///   L(u) = f + sum_k rho_k/2 max(0, g_k + lambda_k/rho_k)^2.
/// Unlike NLopt's AUGLAG, every rho_k starts from the spreads of f and g_k seen so far, every
/// subproblem starts from the last solution with a smaller step, and a global algorithm gets a
/// share of the budget per subproblem (the points that it repeats come from the cache).
/// @throws StopSearch at a limit, NloptFailure when NLopt fails.
SearchOutcome search_augmented(const Search& search, const std::vector<double>& start);

}  // namespace parapet::optimizer
