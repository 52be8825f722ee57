#include "parapet/study/scoring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace parapet::study {
namespace {

using designs::Constraint;
using reports::ConstraintRecord;

const solver::Metric* find_metric(const std::vector<solver::Metric>& metrics,
                                  const std::string& key) {
  const auto found = std::find_if(metrics.begin(), metrics.end(),
                                  [&](const solver::Metric& metric) { return metric.key == key; });
  return found == metrics.end() ? nullptr : &*found;
}

std::optional<double> expression_value(const Constraint& constraint,
                                       const designs::Design& design) {
  try {
    const double value = designs::evaluate_expression(constraint.expression, design);
    if (std::isfinite(value)) return value;
  } catch (const designs::InputError&) {
    // The spec was checked: what fails here fails for these values only, such as a division by 0.
  }
  return std::nullopt;
}

/// One number per limit, lower before upper.
std::vector<double> violations(const Constraint& constraint, std::optional<double> value,
                               bool satisfied_without_value) {
  std::vector<double> result;
  const auto add = [&](double excess) {
    result.push_back(value ? excess / constraint.scale : (satisfied_without_value ? -1.0 : 1.0));
  };
  if (constraint.lower) add(*constraint.lower - value.value_or(0.0));
  if (constraint.upper) add(value.value_or(0.0) - *constraint.upper);
  return result;
}

ConstraintRecord record(const Constraint& constraint, std::optional<double> value,
                        const std::vector<double>& g) {
  ConstraintRecord result;
  result.name = constraint.name;
  result.value = value;
  result.lower = constraint.lower;
  result.upper = constraint.upper;
  result.satisfied =
      std::all_of(g.begin(), g.end(), [](double v) { return v <= feasibility_tolerance; });
  if (value) {
    if (constraint.lower) result.margin = *value - *constraint.lower;
    if (constraint.upper) {
      const double margin = *constraint.upper - *value;
      result.margin = result.margin ? std::min(*result.margin, margin) : margin;
    }
  }
  return result;
}

std::string missing_value(const std::string& key, const solver::Metric* metric) {
  const std::string why = metric == nullptr || metric->absent_reason.empty()
                              ? std::string("the simulation does not give it")
                              : metric->absent_reason;
  return fmt::format("the objective {} has no value: {}", key, why);
}

void score_objectives(const designs::StudySpec& study, const std::vector<solver::Metric>& metrics,
                      Score& result) {
  double sum = 0.0;
  for (const designs::Objective& objective : study.objectives) {
    const solver::Metric* metric = find_metric(metrics, objective.metric);
    const bool absent = metric == nullptr || !metric->value || !std::isfinite(*metric->value);
    const std::optional<double> value = absent ? objective.value_when_absent : metric->value;
    result.objectives.push_back(
        {objective.metric, objective.goal, objective.weight, value, absent});
    if (!value) {
      if (result.problem.empty()) result.problem = missing_value(objective.metric, metric);
      continue;
    }
    const double term = objective.weight * *value / objective.scale;
    sum += objective.goal == designs::Goal::maximize ? -term : term;
  }
  if (result.problem.empty()) result.objective_scalar = sum;
}

int limit_count(const designs::StudySpec& study, bool on_metric) {
  int count = 0;
  for (const Constraint& constraint : study.constraints) {
    if (constraint.metric.empty() == on_metric) continue;
    count += (constraint.lower ? 1 : 0) + (constraint.upper ? 1 : 0);
  }
  return count;
}

}  // namespace

Score score(const designs::StudySpec& study, const designs::Design& design,
            const std::vector<solver::Metric>& metrics) {
  Score result;
  score_objectives(study, metrics, result);
  result.feasible = result.problem.empty();
  for (const Constraint& constraint : study.constraints) {
    std::optional<double> value;
    std::vector<double> g;
    if (constraint.metric.empty()) {
      value = expression_value(constraint, design);
      g = violations(constraint, value, false);
    } else {
      const solver::Metric* metric = find_metric(metrics, constraint.metric);
      if (metric != nullptr && metric->value && std::isfinite(*metric->value)) {
        value = metric->value;
      }
      g = violations(constraint, value, constraint.satisfied_when_absent);
      result.metric_violations.insert(result.metric_violations.end(), g.begin(), g.end());
    }
    result.constraints.push_back(record(constraint, value, g));
    result.feasible = result.feasible && result.constraints.back().satisfied;
  }
  return result;
}

std::vector<ConstraintRecord> score_expressions(const designs::StudySpec& study,
                                                const designs::Design& design) {
  std::vector<ConstraintRecord> result;
  for (const Constraint& constraint : study.constraints) {
    if (!constraint.metric.empty()) continue;
    const auto value = expression_value(constraint, design);
    result.push_back(record(constraint, value, violations(constraint, value, false)));
  }
  return result;
}

std::vector<double> expression_violations(const designs::StudySpec& study,
                                          const designs::Design& design) {
  std::vector<double> result;
  for (const Constraint& constraint : study.constraints) {
    if (!constraint.metric.empty()) continue;
    const auto g = violations(constraint, expression_value(constraint, design), false);
    result.insert(result.end(), g.begin(), g.end());
  }
  return result;
}

int metric_limit_count(const designs::StudySpec& study) {
  return limit_count(study, true);
}

int expression_limit_count(const designs::StudySpec& study) {
  return limit_count(study, false);
}

}  // namespace parapet::study
