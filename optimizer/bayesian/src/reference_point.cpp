#include "reference_point.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/math/pareto.hpp"

namespace parapet::bayesian {
namespace {

/// The reference is at least as bad as this share of what was seen. A front of few designs is much
/// shorter than the true one, and what lies beyond the reference is worth nothing to the search:
/// with the front alone it would crowd into one part (bench/search/zoo_bench).
constexpr double seen_share = 0.9;

/// The value that a share of the points do not exceed.
double quantile_of(const std::vector<Eigen::VectorXd>& points, Eigen::Index objective,
                   double share) {
  std::vector<double> values;
  for (const auto& y : points) values.push_back(y[objective]);
  std::sort(values.begin(), values.end());
  const double last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::lround(share * last))];
}

/// Objectives of what was observed; only feasible designs of the finest level if there are any.
std::vector<Eigen::VectorXd> observed(const Problem& problem, const std::vector<Told>& told,
                                      double tolerance, bool only_feasible) {
  std::vector<Eigen::VectorXd> points;
  for (const Told& t : told) {
    if (!t.ok) continue;
    if (only_feasible && (t.level != 0 || !meets_limits(problem, t.values, tolerance))) continue;
    if (auto y = minimized(problem, t.values)) points.push_back(std::move(*y));
  }
  return points;
}

}  // namespace

std::optional<Eigen::VectorXd> reference_point(const Problem& problem,
                                               const std::vector<Told>& told, double tolerance) {
  const auto n = static_cast<Eigen::Index>(problem.objectives.size());
  Eigen::VectorXd reference = Eigen::VectorXd::Constant(n, std::nan(""));
  for (Eigen::Index j = 0; j < n; ++j) {
    const Objective& objective = problem.objectives[static_cast<std::size_t>(j)];
    if (objective.reference) {
      reference[j] = objective.maximize ? -*objective.reference : *objective.reference;
    }
  }
  if (!reference.hasNaN()) return reference;
  const auto all = observed(problem, told, tolerance, false);
  if (all.empty()) return std::nullopt;
  auto points = observed(problem, told, tolerance, true);
  if (points.empty()) points = all;
  const auto front = math::non_dominated(points);
  for (Eigen::Index j = 0; j < n; ++j) {
    if (!std::isnan(reference[j])) continue;
    double best = points[front.front()][j], worst = best;
    for (const std::size_t k : front) {
      best = std::min(best, points[k][j]);
      worst = std::max(worst, points[k][j]);
    }
    const double beyond_front = worst + 0.1 * (worst - best);
    reference[j] = std::max(beyond_front, quantile_of(points, j, n == 1 ? 1.0 : seen_share));
    if (reference[j] <= best) reference[j] = best + 0.1 * std::max(std::abs(best), 1e-12);
  }
  return reference;
}

}  // namespace parapet::bayesian
