#include "parapet/study/goal_quantity.hpp"

#include <string>

namespace parapet::study {
namespace {

using designs::Statistic;

/// What a goal is called in a quantity.
template <typename Goal>
std::string name_of(const Goal& goal) {
  if (!goal.metric.empty()) return goal.metric;
  return goal.name.empty() ? goal.expression : goal.name;
}

/// Leaves only the members that make a difference.
Quantity canonical(const designs::StudySpec& study, Quantity quantity) {
  const bool one_event = study.scenarios.size() <= 1;
  if (one_event && quantity.statistic != Statistic::probability) {
    quantity.statistic = Statistic::mean;
  }
  if (quantity.statistic != Statistic::quantile) quantity.quantile = 1.0;
  if (quantity.statistic != Statistic::probability) {
    quantity.lower.reset();
    quantity.upper.reset();
  }
  if (quantity.statistic == Statistic::mean || quantity.statistic == Statistic::probability) {
    quantity.high_is_good = false;
  }
  if (quantity.value_when_absent) quantity.absent_is_good = false;
  return quantity;
}

}  // namespace

Quantity objective_quantity(const designs::StudySpec& study, const designs::Objective& objective) {
  return canonical(study, {.metric = name_of(objective),
                           .statistic = objective.statistic,
                           .quantile = objective.quantile,
                           .high_is_good = objective.goal == designs::Goal::maximize,
                           .lower = objective.lower,
                           .upper = objective.upper,
                           .value_when_absent = objective.value_when_absent,
                           .absent_is_good = false,
                           .expression = written_out(objective),
                           .metrics = objective.metrics,
                           .values_when_absent = objective.values_when_absent});
}

std::vector<QuantityLimit> constraint_quantities(const designs::StudySpec& study,
                                                 const designs::Constraint& constraint) {
  Quantity quantity{.metric = name_of(constraint),
                    .statistic = constraint.statistic,
                    .quantile = constraint.quantile,
                    .high_is_good = constraint.lower.has_value(),
                    .lower = constraint.lower,
                    .upper = constraint.upper,
                    .value_when_absent = constraint.value_when_absent,
                    .absent_is_good = constraint.satisfied_when_absent,
                    .expression = written_out(constraint),
                    .metrics = constraint.metrics,
                    .values_when_absent = constraint.values_when_absent};
  if (constraint.statistic == Statistic::probability) {
    return {{.quantity = canonical(study, quantity),
             .lower = constraint.quantile,
             .upper = std::nullopt,
             .scale = 1.0}};
  }
  const Quantity first = canonical(study, quantity);
  quantity.high_is_good = false;
  const Quantity second = canonical(study, quantity);
  if (!constraint.lower || !constraint.upper || first == second) {
    return {{first, constraint.lower, constraint.upper, constraint.scale}};
  }
  return {{first, constraint.lower, std::nullopt, constraint.scale},
          {second, std::nullopt, constraint.upper, constraint.scale}};
}

}  // namespace parapet::study
