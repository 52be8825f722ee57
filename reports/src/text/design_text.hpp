/// Words for designs, objectives and constraints, which several sections share.
#pragma once

#include <optional>
#include <string>

#include "parapet/reports/design_report.hpp"

namespace parapet::reports {

/// "deflector angle 45°, deflector plate and height 0.2 m".
std::string design_words(const WrittenDesign& design);

/// A variable's cell in a table; empty where the design does not have it.
std::string variable_cell(const WrittenDesign& design, const std::string& name);

/// The key whose suffix is an objective's unit; a formula has that of its name, or none.
std::string objective_unit_key(const ObjectiveTerms& objective);

/// An objective's name: "launch length", with its statistic if it has one.
std::string objective_name(const ObjectiveTerms& objective);

/// The same with its unit: "launch length [m]".
std::string objective_label(const ObjectiveTerms& objective);

/// "0.25 m".
std::string objective_value(const ObjectiveTerms& objective, const std::optional<double>& value);

/// What a constraint limits, with unit and statistic; its name where it limits a formula.
std::string constraint_label(const ConstraintResult& constraint);

/// "0.93 (0.91 to 0.95)": an estimate with its 95 % interval; "-" when there is none.
std::string estimate_text(const study::Estimate& estimate);

}  // namespace parapet::reports
