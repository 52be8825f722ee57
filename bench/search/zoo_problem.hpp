// The tests' problems with known fronts in the comparison's terms.
#pragma once

#include "bench_problem.hpp"
#include "multi_objective_zoo.hpp"
#include "score.hpp"

namespace parapet::bench::search {

// What makes a problem harder than its formula.
struct Trouble {
  std::string name;
  double noise = 0.0;            // s.d. of every objective, as a share of reference minus ideal
  double random_failures = 0.0;  // share of evaluations that fail, anywhere and without a pattern
  double failing_region = 0.0;  // share of the box that fails: where the last coordinate is highest
};

BenchProblem zoo_problem(const zoo::ZooProblem& source, const Trouble& trouble);

// The problem's own reference point, and the exact front.
Yardstick zoo_yardstick(const zoo::ZooProblem& source);

}  // namespace parapet::bench::search
