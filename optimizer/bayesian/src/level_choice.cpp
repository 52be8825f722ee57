#include "level_choice.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "composed.hpp"

namespace parapet::bayesian {
Eigen::VectorXd informative_share(const surrogate::GaussianProcess& process,
                                  const Eigen::MatrixXd& inputs, int level) {
  Eigen::VectorXd share = process.correlation_squared(inputs, level);
  const Eigen::VectorXd variance = process.predict(inputs, level).variance;
  const double noise = process.noise(level) * process.noise(level);
  for (Eigen::Index k = 0; k < share.size(); ++k) {
    share[k] = variance[k] > 0.0
                   ? std::clamp(share[k], 0.0, 1.0) * variance[k] / (variance[k] + noise)
                   : 0.0;
  }
  return share;
}

int choose_level(const Problem& problem, const Models& models, const Point& x,
                 const std::vector<double>& seconds, const std::vector<bool>& taken) {
  const Eigen::MatrixXd input = problem.space.features(x);
  std::set<std::size_t> metrics;
  const auto add = [&](std::size_t metric) {
    for (const std::size_t one : modelled_inputs(problem, metric)) metrics.insert(one);
  };
  for (const Objective& objective : problem.objectives) add(objective.metric);
  for (const Limit& limit : problem.limits) add(limit.metric);
  int best = 0;
  double best_value = -1.0;
  for (int level = 0; level < static_cast<int>(problem.levels.size()); ++level) {
    const auto l = static_cast<std::size_t>(level);
    if (level > 0 && taken[l]) continue;
    double share = 1.0;
    for (const std::size_t metric : metrics) {
      const auto* process = models.process(metric);
      if (process != nullptr) share = std::min(share, informative_share(*process, input, level)[0]);
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
