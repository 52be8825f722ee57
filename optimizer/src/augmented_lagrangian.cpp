#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "feasibility.hpp"
#include "search.hpp"

namespace parapet::optimizer {
namespace {

/// Multipliers and penalties of all constraints, in the units of the constraints.
class Lagrangian {
 public:
  explicit Lagrangian(int n_constraints)
      : lambda_(static_cast<std::size_t>(n_constraints), 0.0),
        rho_(lambda_.size(), 0.0),
        margin_(lambda_.size(), 0.0),
        scale_(lambda_.size(), 1.0),
        gap_(lambda_.size(), std::numeric_limits<double>::infinity()) {}

  double value(const Reply& reply) const {
    double sum = reply.objective;
    for (std::size_t k = 0; k < lambda_.size(); ++k) {
      const double excess = reply.constraints[k] + margin_[k] + lambda_[k] / rho_[k];
      if (excess > 0.0) sum += 0.5 * rho_[k] * excess * excess;
    }
    return sum;
  }

  /// Penalties grow to 20 times the spread of f per squared spread of g: exceeding a constraint by
  /// a twentieth of its spread then outweighs the gain expected from doing so.
  void scale_from(const std::vector<Reply>& seen) {
    double f_spread = 0.0;
    for (std::size_t k = 0; k <= lambda_.size(); ++k) {
      const auto entry = [&](const Reply& r) {
        return k == 0 ? r.objective : r.constraints[k - 1];
      };
      double least = entry(seen.front()), most = least, size = 0.0;
      for (const Reply& reply : seen) {
        least = std::min(least, entry(reply));
        most = std::max(most, entry(reply));
        size = std::max(size, std::abs(entry(reply)));
      }
      // One point has no spread: a tenth of the value is the best guess left.
      const double spread = std::max({most - least, 0.1 * size, 1e-9});
      if (k == 0) {
        f_spread = spread;
      } else {
        scale_[k - 1] = spread;
        rho_[k - 1] = std::max(rho_[k - 1], 20.0 * f_spread / (spread * spread));
      }
    }
  }

  /// First-order update at the minimiser of the subproblem. Returns the largest complementarity
  /// gap max(g, -lambda/rho), as a share of each constraint's spread.
  double update(const Reply& at) {
    double largest = 0.0;
    for (std::size_t k = 0; k < lambda_.size(); ++k) {
      const double g = at.constraints[k] + margin_[k];
      const double gap = std::abs(std::max(g, -lambda_[k] / rho_[k]));
      lambda_[k] = std::max(0.0, lambda_[k] + rho_[k] * g);
      if (gap > 0.5 * gap_[k]) rho_[k] *= 4.0;
      gap_[k] = gap;
      largest = std::max(largest, gap / scale_[k]);
    }
    return largest;
  }

  void tighten_by_excess(const Reply& at) {
    for (std::size_t k = 0; k < margin_.size(); ++k) {
      margin_[k] += 1.5 * std::max(0.0, at.constraints[k]);
    }
  }

 private:
  std::vector<double> lambda_, rho_, margin_, scale_, gap_;  // [n_constraints]
};

/// Thrown by the answers of one subproblem when its share of the budget is used up.
struct ShareUsed {};

/// Minimises L over the box; remembers the best point itself.
struct Subproblem {
  const Search& search;
  const Lagrangian& lagrangian;
  std::vector<Reply>& seen;
  int last_evaluation;

  double best_value = std::numeric_limits<double>::infinity();
  std::vector<double> best_u = {};
  std::optional<Reply> best_reply = std::nullopt;

  SearchOutcome solve(const SearchRequest& request) {
    // A share that the start of the algorithm exceeds would never end by itself.
    int repeats = 0;
    const AnswerQuery answer = [&](const std::vector<double>& u) {
      const int before = search.ledger.evaluations();
      if (search.ledger.remaining() > 0 && before >= last_evaluation) throw ShareUsed{};
      const Reply reply = search.ledger.ask(u);
      if (search.ledger.evaluations() > before) {
        seen.push_back(reply);
        repeats = 0;
      } else if (search.algorithm.info.global && ++repeats > 2000 + 2 * before) {
        throw ShareUsed{};
      }
      Reply merged{.objective = lagrangian.value(reply), .constraints = {}};
      if (merged.objective < best_value) {
        best_value = merged.objective;
        best_u = u;
        best_reply = reply;
      }
      return merged;
    };
    try {
      return run_nlopt(request, answer);
    } catch (const ShareUsed&) {
      return {.converged = true, .code = "share of the budget used", .u = best_u};
    }
  }
};

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

SearchOutcome search_augmented(const Search& search, const std::vector<double>& start) {
  constexpr int max_subproblems = 30;
  constexpr int shares = 6;  // subproblems that a global algorithm's budget is divided into
  const bool global = search.algorithm.info.global;
  const double tolerance = search.options.relative_tolerance;
  Lagrangian lagrangian(search.n_constraints);
  std::vector<Reply> seen;
  for (const Point& point : search.ledger.history()) {
    if (point.evaluation.ok) seen.push_back(search.ledger.reply_at(point));
  }
  SearchRequest request = base_request(search, start);
  request.n_constraints = 0;
  const int share = std::max(search.ledger.remaining() / shares,
                             search.algorithm.min_evaluations(search.n_variables));
  SearchOutcome outcome;
  for (int j = 0; j < max_subproblems; ++j) {
    lagrangian.scale_from(seen);
    if (!global) request.tolerance = std::max(tolerance, 0.1 * request.initial_step);
    const int last =
        search.ledger.evaluations() + (global ? share : std::numeric_limits<int>::max() / 2);
    Subproblem subproblem{search, lagrangian, seen, last};
    outcome = subproblem.solve(request);
    if (!outcome.converged) throw NloptFailure("NLopt answered " + outcome.code);
    const Reply& best = *subproblem.best_reply;
    const double moved = largest_difference(subproblem.best_u, request.start);
    const double gap = lagrangian.update(best);
    outcome.u = request.start = subproblem.best_u;
    if (global) continue;
    const bool settled = request.tolerance <= tolerance && moved <= 4.0 * tolerance;
    if (settled && gap <= tolerance) {
      if (violation(best.constraints) <= search.options.feasibility_tolerance) break;
      lagrangian.tighten_by_excess(best);
    }
    request.initial_step = std::max(0.4 * request.initial_step, 5.0 * tolerance);
  }
  return outcome;
}

}  // namespace parapet::optimizer
