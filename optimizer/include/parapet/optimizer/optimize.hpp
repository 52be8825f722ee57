/// optimize(): problem and options in, result out. Third-party optimisers sit behind adapters.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "parapet/optimizer/problem.hpp"

namespace parapet::optimizer {

/// How to search; the defaults suit few variables and an expensive function.
struct Options {
  std::string algorithm = "COBYLA";  ///< NLopt's name, any case, with or without prefix
  std::string local_algorithm;       ///< for MLSL and AUGLAG; empty for all others
  int max_evaluations = 40;          ///< calls of the evaluator, starting points included
  double max_time_s = 0.0;           ///< 0: none
  double relative_tolerance = 1e-3;  ///< on x, as a share of the range
  double initial_step = 0.25;        ///< share of the range, at most 0.5
  std::uint64_t seed = 1;
  std::vector<std::vector<double>> starts;  ///< evaluated first (as one batch)
  int start_count = 0;                      ///< further Sobol' points
  double feasibility_tolerance = 1e-9;      ///< on scaled constraints, the same for every method
  std::function<bool()> cancelled;          ///< polled between evaluations
  /// Told each point that the cheap constraints refuse, also more than once. May be empty.
  std::function<void(const std::vector<double>& x)> on_refused = {};
};

/// Why a search ended.
enum class Termination { converged, budget, time_limit, cancelled, no_feasible_start, failed };

/// The name as it is spelt here: "no_feasible_start".
std::string to_string(Termination termination);

/// One point that was evaluated.
struct Point {
  std::vector<double> x;
  Evaluation evaluation;
  bool feasible = false;  ///< ok and all constraints (cheap ones too) within tolerance
  bool starting = false;  ///< one of the starting designs
};

/// What a search came to.
struct OptimizeResult {
  Termination termination = Termination::failed;
  std::string message;                   ///< in words, with the optimiser's own return code
  std::optional<Point> best;             ///< best feasible point that was really evaluated
  std::optional<Point> best_infeasible;  ///< least violation, when nothing is feasible
  int evaluations = 0;                   ///< evaluator calls (cache hits not counted)
  int cache_hits = 0;
  int rejected = 0;            ///< points refused by the cheap constraints
  std::vector<Point> history;  ///< in order of evaluation
};

/// What an algorithm can do, for checks and docs.
struct AlgorithmInfo {
  std::string name;
  bool global = false;
  bool inequality_constraints = false;  ///< of its own; otherwise the augmented Lagrangian is used
  bool randomized = false;
  std::string note = {};
};

/// Every algorithm that Options::algorithm may name.
const std::vector<AlgorithmInfo>& algorithms();

/// Why these options cannot solve a problem of this shape, one sentence each; empty when they can.
std::vector<std::string> option_errors(const Options& options, int n_variables, int n_constraints);

/// option_errors, and what is wrong with the problem itself or its starting points: bounds that are
/// not finite or not in order, starts outside them, functions not set.
std::vector<std::string> problem_errors(const Problem& problem, const Options& options);

/// Evaluates the starting points, then runs the algorithm from the best of them.
/// Feasibility is judged here from the evaluations, never taken from the algorithm's word.
///
/// Starting points: `starts` that the cheap constraints allow, then `start_count` Sobol' points
/// that they allow; one point (the centre of the box if allowed) where neither is given.
/// DIRECT and AGS choose their own points and ignore them.
/// Constraints: handed to the algorithm where AlgorithmInfo says that it takes them, otherwise an
/// augmented Lagrangian is put around it.
/// Refused points: a point that breaks a cheap constraint is never evaluated; the algorithm is told
/// the constraint's value, and the objective and constraints of the nearest evaluated point.
/// Failed evaluations: the algorithm is told an objective worse than the worst one seen so far and
/// the largest values of the constraints seen so far. Values that are not finite count as failed.
///
/// The same problem and options give the same sequence of points, to the bit: answering `evaluate`
/// from the log of an interrupted run therefore resumes it. Only max_time_s and cancelled() depend
/// on the clock: they cut the sequence short and change nothing before.
/// The search works in shares of each range, rounded to 2^-40; starting points are kept exactly.
/// Randomized algorithms draw from NLopt's generator, one per thread and seeded here: `evaluate`
/// must not call a randomized optimize() on the calling thread.
///
/// @throws std::invalid_argument when problem_errors is not empty; std::logic_error when the
/// evaluator answers a wrong number of values; and whatever the functions of the problem throw.
OptimizeResult optimize(const Problem& problem, const Options& options);

}  // namespace parapet::optimizer
