// Problems with known optima that are hard for a surrogate: narrow feasible regions, scales over
// decades, a cliff at the optimum, a long valley.
#pragma once

#include <vector>

#include "bench_problem.hpp"
#include "score.hpp"

namespace parapet::bench::search {

struct KnownProblem {
  BenchProblem problem;  // `evaluations` is the budget of every method
  double least = 0.0;    // of one objective: its least feasible value
  Yardstick yardstick;   // of several: the best front
  bool one_objective() const { return problem.objectives.size() == 1; }
};

// Gardner et al. (ICML 2014), second simulation: sin a + b where sin a sin b <= -0.95, a region of
// 0.6 % of the square; least value arcsin 0.95 - 1.
KnownProblem gardner();

// A slope that ends at a cliff: the least value lies on the edge, one step of 1 below what follows.
KnownProblem cliff();

// Rosenbrock's valley in n variables within [-2, 2]; least value 0.
KnownProblem rosenbrock(std::size_t n);

// VLMOP2 (Van Veldhuizen 1999) in n variables within [-2, 2]: both objectives are flat, near 1,
// nearly everywhere. Reference (1, 1).
KnownProblem vlmop2(std::size_t n);

// The welded beam (Deb 2001, section 8.3) of two objectives: cost and end deflection; 4 variables,
// 4 limits. The deflection covers three decades. The front is that of 60,000 evaluations of NSGA-II
// and Sobol' points.
KnownProblem welded_beam();

std::vector<KnownProblem> known_problems();

}  // namespace parapet::bench::search
