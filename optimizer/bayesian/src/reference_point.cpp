#include "reference_point.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/acquisition/hypervolume.hpp"

namespace parapet::bayesian {
namespace {

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
  const auto front = acquisition::non_dominated(points);
  for (Eigen::Index j = 0; j < n; ++j) {
    if (!std::isnan(reference[j])) continue;
    double best = points[front.front()][j], worst = best;
    for (const std::size_t k : front) {
      best = std::min(best, points[k][j]);
      worst = std::max(worst, points[k][j]);
    }
    double range = worst - best;
    if (n == 1) {  // a front of one point: measure from the worst design
      for (const auto& y : points) worst = std::max(worst, y[j]);
    } else if (range <= 0.0) {
      double least = all.front()[j], greatest = least;
      for (const auto& y : all) {
        least = std::min(least, y[j]);
        greatest = std::max(greatest, y[j]);
      }
      range = greatest - least;
    }
    reference[j] = worst + (range > 0.0 ? 0.1 * range : 0.1 * std::max(std::abs(worst), 1e-12));
  }
  return reference;
}

}  // namespace parapet::bayesian
