// The search methods that are compared. Each evaluates designs until its budget is spent.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench_problem.hpp"

namespace parapet::bench::search {

// One evaluation, in the order in which the method asked for it.
struct Step {
  Design x;
  int level = 0;
  double seconds = 0.0;  // nominal cost
};

// One run of a method.
struct Run {
  std::uint64_t seed = 0;
  std::vector<Step> steps;
  double own_seconds = 0.0;  // the method's own processor time; Parapet's alone
};

// Counts evaluations. A design that is asked for again costs nothing, one that the cheap
// constraints refuse is never evaluated: Parapet does so for every method.
class Meter {
 public:
  Meter(const BenchProblem& problem, int budget) : problem_(problem), budget_(budget) {}

  // Empty when the budget is spent and the design is not known. Level 0.
  std::optional<Verdict> evaluate(const Design& x);
  bool spent() const { return static_cast<int>(steps_.size()) >= budget_; }
  int left() const { return budget_ - static_cast<int>(steps_.size()); }
  const std::vector<Step>& steps() const { return steps_; }
  const BenchProblem& problem() const { return problem_; }

 private:
  const BenchProblem& problem_;
  int budget_;
  std::vector<Step> steps_;
  std::map<Design, Verdict> known_;
};

// Sobol' points with a random shift, those that the cheap constraints allow.
Run random_search(const BenchProblem& problem, std::uint64_t seed, int budget);

// An NLopt algorithm on scalarised problems that share the budget: augmented Chebyshev
//   max_j w_j z_j + 0.05 sum_j w_j z_j   (Steuer and Choo, Math. Program. 26 (1983) 326-344),
// z_j being objective j scaled to 0..1 over the first designs (Sobol' points, part of the budget).
// The weights rotate; a round that leaves evaluations is followed by another from new points.
Run scalarised_search(const BenchProblem& problem, const std::string& algorithm, std::uint64_t seed,
                      int budget);

// pagmo2's NSGA-II (Deb et al., IEEE Trans. Evol. Comput. 6 (2002) 182-197). pagmo's knows no
// constraints. A design that breaks limits gets every objective 1e6 + its total violation (1e9 and
// more if the cheap constraints refuse it, 1e8 if it failed): then Pareto dominance is the
// constrained dominance of that paper.
Run nsga2_search(const BenchProblem& problem, int population, std::uint64_t seed, int budget);

// bayesian::Search; all levels of the problem, or only the finest. Ends early when max_seconds of
// nominal cost are spent.
Run bayesian_search(const BenchProblem& problem, bool all_levels, std::uint64_t seed, int budget,
                    double max_seconds = std::numeric_limits<double>::infinity());

// Non-dominated designs of the noise-free problem found with a large budget, by NSGA-II and by
// Sobol' points: what the score is held against. Objectives, minimised.
std::vector<Eigen::VectorXd> brute_force_front(const BenchProblem& problem, int evaluations);

}  // namespace parapet::bench::search
