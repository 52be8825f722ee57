/// Every evaluation goes through here: budget, cache, refusals, failures, history.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "parapet/optimizer/optimize.hpp"
#include "unit_box.hpp"

namespace parapet::optimizer {

/// Thrown by the ledger to end a search; never leaves optimize().
struct StopSearch {
  Termination termination;
  std::string message;
};

/// What an algorithm is told at a point; all numbers are finite.
struct Reply {
  double objective = 0.0;
  std::vector<double> constraints;  ///< [n_cheap + n_constraints], cheap ones first
};

/// Answers queries at points of the unit box from the cache or by a real evaluation.
///
/// A point refused by the cheap constraints is not evaluated: the reply holds its own cheap values
/// and the objective and constraints of the nearest successful evaluation (Euclid, unit box), so
/// that the cheap constraints alone push the algorithm back.
/// A failed evaluation is answered with an objective worse than the worst one seen so far by a
/// tenth of the spread, and with the largest value seen so far of each constraint.
class EvaluationLedger {
 public:
  /// All three must outlive the ledger.
  EvaluationLedger(const Problem& problem, const Options& options, const UnitBox& box);

  /// Evaluates the starting points as one batch, duplicates once. xs: [n_starts][n], within the
  /// bounds, allowed by the cheap constraints.
  /// @throws StopSearch when cancelled before or (without evaluate_batch) during it.
  void evaluate_starts(const std::vector<std::vector<double>>& xs);

  /// The answer at u [n]. @throws StopSearch when a limit of the options is reached or the
  /// algorithm goes on asking without ever reaching a point that needs an evaluation.
  Reply ask(const std::vector<double>& u);

  /// The answer at an evaluated point.
  Reply reply_at(const Point& point) const;

  /// Counts a point that was refused, and tells of it.
  void refuse(const std::vector<double>& x);

  bool any_success() const { return n_success_ > 0; }
  int evaluations() const { return static_cast<int>(history_.size()); }
  int remaining() const { return options_.max_evaluations - evaluations(); }
  int cache_hits() const { return cache_hits_; }
  int failures() const { return evaluations() - n_success_; }
  int rejected() const { return rejected_; }
  const std::vector<Point>& history() const { return history_; }

  /// c [n_cheap] at x, checked for its length.
  std::vector<double> cheap_values(const std::vector<double>& x) const;

 private:
  void check_limits() const;
  void guard_against_stalling();
  Evaluation evaluate(const std::vector<double>& x) const;
  const Point& record(const std::vector<double>& x, Evaluation evaluation, bool starting);
  const Point& nearest_success(const std::vector<double>& u) const;

  const Problem& problem_;
  const Options& options_;
  const UnitBox& box_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::vector<Point> history_;
  std::vector<std::vector<double>> units_;              // [evaluations][n]
  std::unordered_map<std::string, std::size_t> cache_;  // bytes of x -> index in history
  double best_objective_ = 0.0, worst_objective_ = 0.0;
  std::vector<double> worst_constraints_;
  int n_success_ = 0;
  int cache_hits_ = 0;
  int rejected_ = 0;
  int queries_since_evaluation_ = 0;
};

}  // namespace parapet::optimizer
