/// What counts as feasible. The only place that decides it.
#pragma once

#include <optional>
#include <vector>

#include "parapet/optimizer/optimize.hpp"

namespace parapet::optimizer {

/// Largest amount by which a constraint g <= 0 is exceeded; 0 when none is. A NaN counts as
/// infinite.
double violation(const std::vector<double>& constraints);

/// The feasible point of the least objective; the earliest of equals.
std::optional<Point> best_feasible(const std::vector<Point>& history);

/// Among the points whose evaluation succeeded: least violation, then least objective.
std::optional<Point> least_violating(const std::vector<Point>& history);

}  // namespace parapet::optimizer
