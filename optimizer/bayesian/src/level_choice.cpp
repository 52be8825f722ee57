#include "level_choice.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace parapet::bayesian {
namespace {

/// Share of the finest level's unknown that an observation at this level would settle, 0 .. 1.
double informative_share(const surrogate::GaussianProcess& process, const Eigen::MatrixXd& input,
                         int level) {
  const double correlation = process.correlation_squared(input, level)[0];
  const double variance = process.predict(input, level).variance[0];
  const double noise = process.noise(level) * process.noise(level);
  if (!(variance > 0.0)) return 0.0;
  return std::clamp(correlation, 0.0, 1.0) * variance / (variance + noise);
}

}  // namespace

int choose_level(const Problem& problem, const Models& models, const Point& x,
                 const std::vector<double>& seconds, const std::vector<bool>& taken) {
  const Eigen::MatrixXd input = problem.space.features(x);
  std::set<std::size_t> metrics;
  for (const Objective& objective : problem.objectives) metrics.insert(objective.metric);
  for (const Limit& limit : problem.limits) metrics.insert(limit.metric);
  int best = 0;
  double best_value = -1.0;
  for (int level = 0; level < static_cast<int>(problem.levels.size()); ++level) {
    const auto l = static_cast<std::size_t>(level);
    if (level > 0 && taken[l]) continue;
    double share = 1.0;
    for (const std::size_t metric : metrics) {
      const auto* process = models.process(metric);
      if (process != nullptr) share = std::min(share, informative_share(*process, input, level));
    }
    const double value = share / std::max(seconds[l], 1e-12);
    if (value > best_value) {
      best = level;
      best_value = value;
    }
  }
  return best;
}

}  // namespace parapet::bayesian
