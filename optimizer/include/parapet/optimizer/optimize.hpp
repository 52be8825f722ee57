/// optimize(): problem and options in, result out. Third-party optimisers sit behind adapters.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "parapet/optimizer/problem.hpp"

namespace parapet::optimizer {

struct Options {
  std::string algorithm = "COBYLA";    ///< NLopt's name without prefix
  std::string local_algorithm;         ///< for MLSL and AUGLAG
  int max_evaluations = 40;            ///< calls of the evaluator, starting points included
  double max_time_s = 0.0;             ///< 0: none
  double relative_tolerance = 1e-3;    ///< on x, as a share of the range
  double initial_step = 0.25;          ///< share of the range
  std::uint64_t seed = 1;
  std::vector<std::vector<double>> starts;  ///< evaluated first (as one batch)
  int start_count = 0;                      ///< further Sobol' points
  double feasibility_tolerance = 1e-9;      ///< on scaled constraints, the same for every method
  std::function<bool()> cancelled;          ///< polled between evaluations
};

enum class Termination { converged, budget, time_limit, cancelled, no_feasible_start, failed };
std::string to_string(Termination termination);

/// One point that was evaluated.
struct Point {
  std::vector<double> x;
  Evaluation evaluation;
  bool feasible = false;      ///< ok and all constraints (cheap ones too) within tolerance
  bool starting = false;      ///< one of the starting designs
};

struct OptimizeResult {
  Termination termination = Termination::failed;
  std::string message;                 ///< in words, with the optimiser's own return code
  std::optional<Point> best;           ///< best feasible point that was really evaluated
  std::optional<Point> best_infeasible;///< least violation, when nothing is feasible
  int evaluations = 0;                 ///< evaluator calls (cache hits not counted)
  int cache_hits = 0;
  int rejected = 0;                    ///< points refused by the cheap constraints
  std::vector<Point> history;          ///< in order of evaluation
};

/// What an algorithm can do, for checks and docs.
struct AlgorithmInfo {
  std::string name;
  bool global = false;
  bool inequality_constraints = false;  ///< of its own; otherwise the augmented Lagrangian is used
  bool randomized = false;
  std::string note;
};
const std::vector<AlgorithmInfo>& algorithms();

/// Why these options cannot solve a problem of this shape, one sentence each; empty when they can.
std::vector<std::string> option_errors(const Options& options, int n_variables, int n_constraints);

/// Evaluates the starting points, then runs the algorithm from the best of them.
/// Feasibility is judged here from the evaluations, never taken from the algorithm's word.
/// @throws std::invalid_argument when option_errors is not empty.
OptimizeResult optimize(const Problem& problem, const Options& options);

}  // namespace parapet::optimizer
