// A problem of the comparison as the Bayesian search sees it.
#pragma once

#include "bench_problem.hpp"
#include "parapet/bayesian/problem.hpp"

namespace parapet::bench::search {

// All levels of the problem, or only the finest. The reference point is left to the search.
bayesian::Problem as_bayesian(const BenchProblem& problem, bool all_levels);

// What an evaluation at x tells; its cost is the level's nominal one.
bayesian::Observation observe(const BenchProblem& problem, const Design& x, int level);

}  // namespace parapet::bench::search
