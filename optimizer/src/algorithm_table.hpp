/// NLopt's algorithms that need no gradients, and how names are read.
#pragma once

#include <string>

#include "parapet/optimizer/optimize.hpp"

namespace parapet::optimizer {

struct AlgorithmEntry {
  AlgorithmInfo info;
  std::string nlopt_name = {};  ///< "LN_COBYLA"; empty for AUGLAG, which is this library's own
  bool needs_local = false;
  bool usable_as_local = false;
  int min_variables = 1;
  int max_variables = 0;  ///< 0: any
  /// Evaluations before the algorithm can do anything of its own: points_per_variable n + points.
  int points_per_variable = 0;
  int points = 2;

  int min_evaluations(int n_variables) const { return points_per_variable * n_variables + points; }
};

const std::vector<AlgorithmEntry>& algorithm_table();

/// The entry of a name in any case, with - or _, with or without NLOPT_ and LN_/GN_/G_; null and a
/// sentence in `why_not` when there is none.
const AlgorithmEntry* find_algorithm(const std::string& name, std::string& why_not);

/// Size of the population (0: the algorithm has none, or keeps NLopt's default) such that several
/// generations fit into the budget.
int population_for(const AlgorithmEntry& entry, int n_variables, int max_evaluations);

}  // namespace parapet::optimizer
