#include "told.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::bayesian {
namespace {

/// How far a value is outside the limits, as a share of the limit's size (of 1 where that is 0).
double excess(double limit, double beyond) {
  const double size = std::abs(limit);
  return beyond / (size > 0.0 ? size : 1.0);
}

}  // namespace

bool meets_limits(const Problem& problem, const std::vector<std::optional<double>>& values,
                  double tolerance) {
  return std::all_of(problem.limits.begin(), problem.limits.end(), [&](const Limit& limit) {
    const std::optional<double>& value = values[limit.metric];
    if (!value) return limit.satisfied_when_absent;
    const bool above =
        !std::isfinite(limit.lower) || excess(limit.lower, limit.lower - *value) <= tolerance;
    const bool below =
        !std::isfinite(limit.upper) || excess(limit.upper, *value - limit.upper) <= tolerance;
    return above && below;
  });
}

std::optional<Eigen::VectorXd> minimized(const Problem& problem,
                                         const std::vector<std::optional<double>>& values) {
  Eigen::VectorXd y(static_cast<Eigen::Index>(problem.objectives.size()));
  for (std::size_t j = 0; j < problem.objectives.size(); ++j) {
    const auto& value = values[problem.objectives[j].metric];
    if (!value) return std::nullopt;
    y[static_cast<Eigen::Index>(j)] = problem.objectives[j].maximize ? -*value : *value;
  }
  return y;
}

}  // namespace parapet::bayesian
