/// One design as JSON.
#pragma once

#include <optional>
#include <vector>

#include "parapet/reports/design_report.hpp"

namespace parapet::reports {

/// Null for what is missing or not finite.
designs::Json optional_json(const std::optional<double>& value);

/// {name: number or option}
designs::Json to_json(const WrittenDesign& design);

/// {name, metric, goal, expression?, statistic?}. A formula's unit is that of its name, so that
/// stands for the metric.
designs::Json to_json(const ObjectiveTerms& terms);

/// [{name, metric, goal, ..., value, estimate, lower_95, upper_95}]
designs::Json estimates_json(const std::vector<ObjectiveEstimate>& estimates);

/// Everything about one design: id, design, variables, objectives, constraints, metrics.
designs::Json to_json(const DesignReport& design);

}  // namespace parapet::reports
