/// What the objectives and constraints of a study are about, as quantities.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/study/quantity.hpp"

namespace parapet::study {

/// The expression of an objective or constraint, its terms written out; empty for a metric.
template <typename Goal>
const std::string& written_out(const Goal& goal) {
  return goal.formula.empty() ? goal.expression : goal.formula;
}

/// What an objective that needs a simulation is about. With one event every statistic but the
/// probability is the metric itself, and is then called the mean.
Quantity objective_quantity(const designs::StudySpec& study, const designs::Objective& objective);

/// A limit of a constraint that needs a simulation, and the quantity that it limits.
struct QuantityLimit {
  Quantity quantity;
  std::optional<double> lower, upper;
  double scale = 1.0;  ///< a violation is divided by it
};

/// What a constraint that needs a simulation limits, lower limits first. One entry where the
/// statistic does not depend on which end is good; with the statistics worst and quantile one for
/// each limit. The statistic probability becomes a lower limit `quantile` on the probability,
/// scale 1.
std::vector<QuantityLimit> constraint_quantities(const designs::StudySpec& study,
                                                 const designs::Constraint& constraint);

}  // namespace parapet::study
