#include "feasibility.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace parapet::optimizer {

double violation(const std::vector<double>& constraints) {
  double worst = 0.0;
  for (const double g : constraints) {
    if (std::isnan(g)) return std::numeric_limits<double>::infinity();
    if (g > worst) worst = g;
  }
  return worst;
}

std::optional<Point> best_feasible(const std::vector<Point>& history) {
  const Point* best = nullptr;
  for (const Point& point : history) {
    if (!point.feasible) continue;
    if (!best || point.evaluation.objective < best->evaluation.objective) best = &point;
  }
  return best ? std::optional<Point>(*best) : std::nullopt;
}

std::optional<Point> least_violating(const std::vector<Point>& history) {
  const Point* best = nullptr;
  std::pair<double, double> best_rank;
  for (const Point& point : history) {
    if (!point.evaluation.ok) continue;
    const std::pair rank(violation(point.evaluation.constraints), point.evaluation.objective);
    if (!best || rank < best_rank) {
      best = &point;
      best_rank = rank;
    }
  }
  return best ? std::optional<Point>(*best) : std::nullopt;
}

}  // namespace parapet::optimizer
