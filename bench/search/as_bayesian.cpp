#include "as_bayesian.hpp"

namespace parapet::bench::search {

bayesian::Problem as_bayesian(const BenchProblem& problem, bool all_levels) {
  std::vector<bayesian::Variable> variables;
  for (std::size_t j = 0; j < problem.dimension(); ++j) {
    variables.push_back({problem.variables[j], bayesian::VariableKind::continuous, problem.lower[j],
                         problem.upper[j], std::nullopt});
  }
  bayesian::Problem out;
  out.space = bayesian::Space(variables);
  for (const BenchMetric& m : problem.metrics) {
    bayesian::Metric metric;
    metric.name = m.name;
    metric.exact = m.exact;
    metric.least = m.least;
    metric.greatest = m.greatest;
    out.metrics.push_back(metric);
  }
  // the reference point is left to the search, as a user would
  for (const BenchObjective& o : problem.objectives) {
    out.objectives.push_back({o.metric, o.maximize, std::nullopt});
  }
  for (const BenchLimit& l : problem.limits) {
    out.limits.push_back({l.metric, l.lower, l.upper, true});
  }
  out.levels.clear();
  const std::size_t n_levels = all_levels ? problem.level_seconds.size() : 1;
  for (std::size_t level = 0; level < n_levels; ++level) {
    out.levels.push_back({problem.level_seconds[level]});
  }
  out.cheap_constraints = problem.cheap_constraints;
  return out;
}

bayesian::Observation observe(const BenchProblem& problem, const Design& x, int level) {
  const Answer answer = problem.evaluate(x, level);
  bayesian::Observation observation;
  observation.ok = answer.ok;
  observation.seconds =
      answer.seconds.value_or(problem.level_seconds[static_cast<std::size_t>(level)]);
  observation.values.assign(problem.metrics.size(), std::nullopt);
  if (!answer.ok) return observation;
  for (std::size_t m = 0; m < problem.metrics.size(); ++m) {
    if (!problem.metrics[m].exact) observation.values[m] = answer.values[m];
  }
  for (const BenchObjective& o : problem.objectives) {
    std::optional<double>& value = observation.values[o.metric];
    if (!value && !problem.metrics[o.metric].exact) value = o.value_when_absent;
  }
  return observation;
}

}  // namespace parapet::bench::search
