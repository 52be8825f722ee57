/// Parts of a recommendation's JSON that are about one design or the study as a whole.
#pragma once

#include "design_choice.hpp"
#include "study_log.hpp"

namespace parapet::reports {

designs::Json optional_json(const std::optional<double>& value);

/// 100 part / |whole|; null without both.
designs::Json percent_json(const std::optional<double>& part, const std::optional<double>& whole);

/// The design as people write it: options by name, variables that do not exist left out.
designs::Json written_design(const StudyLog& log, const LoggedDesign& design);

/// [{name, value, lower, upper, at_bound}], active variables only; a choice has "option" and
/// "options" instead of bounds.
designs::Json variables_json(const StudyLog& log, const LoggedDesign& design);

/// Everything about one design: id, design, objectives, constraints, metrics.
designs::Json design_json(const StudyLog& log, const LoggedDesign& design);

/// [{name, metric, goal, statistic, value, estimate, lower_95, upper_95}] of a candidate.
designs::Json estimates_json(const Candidate& candidate);

/// What was studied: variables, objectives, constraints, scenarios, spacings, numbers, method.
designs::Json study_json(const StudyLog& log);

}  // namespace parapet::reports
