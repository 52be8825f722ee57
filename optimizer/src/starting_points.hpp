/// Where the search begins.
#pragma once

#include <string>
#include <vector>

#include "evaluation_ledger.hpp"

namespace parapet::optimizer {

/// The user's starts that the cheap constraints allow (refused ones are counted in the ledger),
/// then options.start_count Sobol' points that they allow; at least one point in all where any
/// can be found. Where the allowed part of the box is too thin to be hit, Sobol' points are moved
/// to the nearest allowed point, which costs no evaluation.
/// @returns xs [n_starts][n]; empty when no allowed point was found.
std::vector<std::vector<double>> choose_starts(const Problem& problem, const Options& options,
                                               const UnitBox& box, EvaluationLedger& ledger);

}  // namespace parapet::optimizer
