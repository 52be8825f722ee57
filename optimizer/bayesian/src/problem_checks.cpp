#include "problem_checks.hpp"

#include <cmath>

namespace parapet::bayesian {

std::string problem_error(const Problem& problem, const SearchOptions& options) {
  if (problem.space.size() == 0) return "there are no variables";
  if (problem.objectives.empty()) return "there are no objectives";
  if (problem.levels.empty()) return "there is no level of fidelity";
  for (const Objective& objective : problem.objectives) {
    if (objective.metric >= problem.metrics.size()) return "an objective has no metric";
    if (objective.reference && !std::isfinite(*objective.reference)) {
      return "the reference of " + problem.metrics[objective.metric].name + " is not finite";
    }
  }
  for (const Limit& limit : problem.limits) {
    if (limit.metric >= problem.metrics.size()) return "a limit has no metric";
    if (!(limit.lower <= limit.upper)) {
      return "the limits of " + problem.metrics[limit.metric].name + " are not in order";
    }
  }
  for (const Metric& metric : problem.metrics) {
    const std::size_t n = metric.known_noise.size();
    for (const std::size_t input : metric.composition.inputs) {
      if (!metric.is_composed() || input >= problem.metrics.size() ||
          problem.metrics[input].exact || problem.metrics[input].is_composed()) {
        return metric.name + " is composed of what has no surrogate";
      }
    }
    if (metric.is_composed() && (metric.exact || metric.composition.inputs.empty())) {
      return metric.name + " is composed of nothing, or exact as well";
    }
    if (n != 0 && n != problem.levels.size()) {
      return "the noise of " + metric.name + " is not given for every level";
    }
  }
  for (const Point& start : options.starts) {
    if (start.size() != problem.space.size()) return "a start has a wrong number of values";
  }
  if (options.max_evaluations < 1) return "max_evaluations is less than 1";
  if (options.samples < 1) return "there must be at least one posterior sample";
  return {};
}

}  // namespace parapet::bayesian
