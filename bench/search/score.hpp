// How good a run was: the hypervolume of its designs' true values against the best that exists.
#pragma once

#include <array>
#include <vector>

#include "methods.hpp"
#include "runs_file.hpp"

namespace parapet::bench::search {

// What a run is held against.
struct Yardstick {
  Eigen::VectorXd reference;           // point, minimised objectives
  std::vector<Eigen::VectorXd> front;  // best known
  double volume = 0.0;                 // dominated by the front below the reference
};

// Reference point: of each objective the worse of two values. One is the worst on the front and a
// tenth of the front's range beyond it, so that all of the front counts (the median alone leaves
// most of it out where half of the designs are as good as can be). The other is the median over
// 4096 Sobol' designs that are allowed and feasible, so that a front of a few designs is not
// measured by itself.
// @throws std::invalid_argument when none of them is feasible or the volume is 0.
Yardstick make_yardstick(const BenchProblem& problem, std::vector<Eigen::VectorXd> front);

// Adds what the runs have found beyond the front, so that no run exceeds 1.
void extend(Yardstick& yardstick, const BenchProblem& problem, const std::vector<MethodRuns>& all);

// After each step: the share of the volume that the run's designs dominate. Only designs evaluated
// at the finest level and truly feasible count, and they count with their true values, so that
// lucky noise earns nothing.
struct Curve {
  std::vector<double> share;    // [n_steps]
  std::vector<double> seconds;  // [n_steps] nominal cost until then
};
Curve score(const BenchProblem& problem, const Yardstick& yardstick, const Run& run);

inline constexpr std::array<double, 3> targets = {0.90, 0.95, 0.99};

// A method's score over its seeds. Infinite where the target is not reached within the budget.
struct MethodScore {
  std::string method, label, family;
  std::vector<Curve> curves;                     // [n_seeds]
  std::array<double, 3> evaluations{};           // median to reach each target
  std::array<double, 3> seconds{};               // the same in nominal seconds
  std::array<int, 3> reached{};                  // runs that reached it
  std::array<double, 3> worst_evaluations{};     // of the slowest run
  double worst_share = 0.0;                      // least at the end of the budget
  std::vector<double> median_share;              // [budget] after each evaluation
  std::vector<double> lower_share, upper_share;  // quartiles
  double own_seconds = 0.0;                      // median over runs
  int budget = 0;                                // evaluations of the longest run
};
MethodScore score(const BenchProblem& problem, const Yardstick& yardstick, const MethodRuns& runs);

// Better first: the 95 % target, then the share at the end of the budget.
bool better(const MethodScore& a, const MethodScore& b);

// Quantile of a few numbers by linear interpolation, p in 0..1.
double quantile(std::vector<double> values, double p);

}  // namespace parapet::bench::search
