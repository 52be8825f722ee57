#include "parapet/study/scoring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parapet/study/goal_quantity.hpp"

namespace parapet::study {
namespace {

using designs::Constraint;
using records::ConstraintRecord;

/// What a constraint limits: the value, its limits and the scale of a violation.
struct LimitedValue {
  std::optional<double> value;
  std::optional<double> lower, upper;
  double scale = 1.0;
  bool satisfied_without_value = false;

  /// One number per limit, lower before upper.
  std::vector<double> violations() const {
    std::vector<double> result;
    const auto add = [&](double excess) {
      result.push_back(value ? excess / scale : (satisfied_without_value ? -1.0 : 1.0));
    };
    if (lower) add(*lower - value.value_or(0.0));
    if (upper) add(value.value_or(0.0) - *upper);
    return result;
  }

  /// Distance to the nearer limit.
  std::optional<double> margin() const {
    if (!value) return std::nullopt;
    std::optional<double> result;
    if (lower) result = *value - *lower;
    if (upper && (!result || *upper - *value < *result)) result = *upper - *value;
    return result;
  }
};

/// An objective or constraint that needs no simulation.
template <typename Goal>
std::optional<double> design_formula(const designs::StudySpec& study, const Goal& goal,
                                     const designs::Design& design) {
  return formula_value(study, goal.formula.empty() ? goal.expression : goal.formula, design);
}

std::vector<LimitedValue> limited_values(const designs::StudySpec& study,
                                         const Constraint& constraint,
                                         const designs::Design& design,
                                         const std::vector<Event>& events) {
  if (constraint.is_of_design()) {
    return {{design_formula(study, constraint, design), constraint.lower, constraint.upper,
             constraint.scale, false}};
  }
  std::vector<LimitedValue> result;
  for (const QuantityLimit& limit : constraint_quantities(study, constraint)) {
    const QuantityValue found = quantity_value(study, limit.quantity, design, events);
    result.push_back({found.value, limit.lower, limit.upper, limit.scale,
                      constraint.satisfied_when_absent && !found.unknown});
  }
  return result;
}

std::vector<double> violations(const std::vector<LimitedValue>& limited) {
  std::vector<double> result;
  for (const LimitedValue& one : limited) {
    const auto g = one.violations();
    result.insert(result.end(), g.begin(), g.end());
  }
  return result;
}

/// The value in the record is the one nearest to its limit, or the first that is missing where that
/// is a violation.
ConstraintRecord record(const Constraint& constraint, const std::vector<LimitedValue>& limited) {
  ConstraintRecord result;
  result.name = constraint.name;
  result.tolerance = feasibility_tolerance * constraint.scale;
  const auto g = violations(limited);
  result.satisfied =
      std::all_of(g.begin(), g.end(), [](double v) { return v <= feasibility_tolerance; });
  bool missing = false;
  for (const LimitedValue& one : limited) {
    if (one.lower) result.lower = one.lower;
    if (one.upper) result.upper = one.upper;
    missing = missing || (!one.value && !one.satisfied_without_value);
    const auto margin = one.margin();
    if (!margin || (result.margin && *result.margin <= *margin)) continue;
    result.margin = margin;
    result.value = one.value;
  }
  if (missing) {
    result.value.reset();
    result.margin.reset();
  }
  return result;
}

void score_objectives(const designs::StudySpec& study, const designs::Design& design,
                      const std::vector<Event>& events, Score& result) {
  double sum = 0.0;
  for (const designs::Objective& objective : study.objectives) {
    const std::string name = objective_name(objective);
    QuantityValue found;
    if (objective.is_of_design()) {
      found.value = design_formula(study, objective, design);
      found.reason = "the formula has no finite value for this design";
    } else {
      found = quantity_value(study, objective_quantity(study, objective), design, events);
    }
    result.objectives.push_back(
        {name, objective.goal, objective.weight, found.value, found.absent});
    if (!found.value) {
      if (result.problem.empty()) {
        result.problem = fmt::format("the objective {} has no value: {}", name, found.reason);
      }
      continue;
    }
    const double term = objective.weight * *found.value / objective.scale;
    sum += objective.goal == designs::Goal::maximize ? -term : term;
  }
  if (result.problem.empty()) result.objective_scalar = sum;
}

/// The study's terms at a design: means over the events that have a value, as of metrics.
std::vector<records::TermRecord> term_values(const designs::StudySpec& study,
                                             const designs::Design& design,
                                             const std::vector<Event>& events) {
  std::vector<records::TermRecord> result;
  for (const designs::Term& term : study.terms) {
    Quantity quantity{.metric = term.name, .lower = {}, .upper = {}, .value_when_absent = {}};
    quantity.absent_is_good = true;
    quantity.expression = term.formula;
    quantity.metrics = term.metrics;
    quantity.values_when_absent = term.values_when_absent;
    result.push_back({term.name, quantity_value(study, quantity, design, events).value});
  }
  return result;
}

int limit_count(const designs::StudySpec& study, bool of_simulation) {
  int count = 0;
  for (const Constraint& constraint : study.constraints) {
    if (constraint.is_of_design() == of_simulation) continue;
    const bool one = of_simulation && constraint.statistic == designs::Statistic::probability;
    count += one ? 1 : (constraint.lower ? 1 : 0) + (constraint.upper ? 1 : 0);
  }
  return count;
}

}  // namespace

std::optional<double> formula_value(const designs::StudySpec& study, const std::string& expression,
                                    const designs::Design& design) {
  try {
    const double value = designs::evaluate_expression(study, expression, design);
    if (std::isfinite(value)) return value;
  } catch (const designs::InputError&) {
    // The spec was checked: what fails here fails for these values only, such as a division by 0.
  }
  return std::nullopt;
}

std::vector<double> limit_violations(const Constraint& constraint, std::optional<double> value) {
  return LimitedValue{value, constraint.lower, constraint.upper, constraint.scale, false}
      .violations();
}

std::string objective_name(const designs::Objective& objective) {
  if (!objective.name.empty()) return objective.name;
  return objective.metric.empty() ? objective.expression : objective.metric;
}

std::vector<double> minimized_objectives(const records::EvaluationRecord& record) {
  std::vector<double> values;
  for (const records::ObjectiveRecord& objective : record.objectives) {
    if (!objective.value) return {};
    values.push_back(objective.goal == designs::Goal::maximize ? -*objective.value
                                                               : *objective.value);
  }
  return values;
}

Score score(const designs::StudySpec& study, const designs::Design& design,
            const std::vector<Event>& events) {
  Score result;
  score_objectives(study, design, events, result);
  result.terms = term_values(study, design, events);
  result.feasible = result.problem.empty();
  for (const Constraint& constraint : study.constraints) {
    const auto limited = limited_values(study, constraint, design, events);
    if (!constraint.is_of_design()) {
      const auto g = violations(limited);
      result.metric_violations.insert(result.metric_violations.end(), g.begin(), g.end());
    }
    result.constraints.push_back(record(constraint, limited));
    result.feasible = result.feasible && result.constraints.back().satisfied;
  }
  return result;
}

Score score(const designs::StudySpec& study, const designs::Design& design,
            const std::vector<solver::Metric>& metrics) {
  return score(study, design, std::vector<Event>{{"", 1.0, metrics}});
}

std::vector<ConstraintRecord> score_expressions(const designs::StudySpec& study,
                                                const designs::Design& design) {
  std::vector<ConstraintRecord> result;
  for (const Constraint& constraint : study.constraints) {
    if (!constraint.is_of_design()) continue;
    result.push_back(record(constraint, limited_values(study, constraint, design, {})));
  }
  return result;
}

std::vector<double> expression_violations(const designs::StudySpec& study,
                                          const designs::Design& design) {
  std::vector<double> result;
  for (const Constraint& constraint : study.constraints) {
    if (!constraint.is_of_design()) continue;
    const auto g = violations(limited_values(study, constraint, design, {}));
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
