/// What is to be optimised. Knows nothing of barriers or particles.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace parapet::optimizer {

/// One answer of the (expensive) evaluator at a point.
struct Evaluation {
  bool ok = false;                  ///< false: the evaluation failed; values are then empty
  std::string reason;               ///< why it failed
  double objective = 0.0;           ///< scalar, to be minimised
  std::vector<double> constraints;  ///< [n_constraints], satisfied when <= 0 (scaled)
};

/// minimise f(x), lower <= x <= upper, g_k(x) <= 0 (from the same evaluation as f),
/// c_l(x) <= 0 (cheap: needs no evaluation).
struct Problem {
  std::vector<std::string> names;    ///< [n]
  std::vector<double> lower, upper;  ///< [n]
  int n_constraints = 0;             ///< g, answered by evaluate
  /// c [n_cheap] at x; tested before evaluate is called.
  int n_cheap_constraints = 0;
  std::function<std::vector<double>(const std::vector<double>& x)> cheap_constraints;
  /// The expensive evaluator. Must be deterministic; results are cached by exact x.
  std::function<Evaluation(const std::vector<double>& x)> evaluate;
  /// Optional: several points at once (starting designs); default: one after the other.
  std::function<std::vector<Evaluation>(const std::vector<std::vector<double>>& xs)> evaluate_batch;
};

}  // namespace parapet::optimizer
