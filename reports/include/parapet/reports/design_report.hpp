/// What advice says of one design.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/solver/result.hpp"
#include "parapet/study/stored_front.hpp"

namespace parapet::reports {

/// A variable of a design as people write it: a number, or the name of a choice's option.
struct WrittenVariable {
  std::string name;
  std::variant<double, std::string> value;
};

/// Variables that do not exist under the options taken are left out.
using WrittenDesign = std::vector<WrittenVariable>;

/// "maximize" or "minimize", as specs say it.
inline const char* goal_word(designs::Goal goal) {
  return goal == designs::Goal::maximize ? "maximize" : "minimize";
}

/// What an objective is, whatever its value.
struct ObjectiveTerms {
  std::string name;        ///< in the spec
  std::string metric;      ///< the metric's key; empty for a formula
  std::string expression;  ///< the formula; empty for a metric
  designs::Goal goal = designs::Goal::maximize;
  std::string statistic;  ///< over the scenarios, in words; empty where there is one event
};

/// What an objective came to at a design.
struct ObjectiveResult {
  ObjectiveTerms terms;
  double weight = 1.0;
  std::optional<double> value;  ///< as simulated
  bool absent = false;          ///< the metric has no value: `value` stands in for it
};

/// What an objective came to, and what the surrogate says of it.
struct ObjectiveEstimate {
  ObjectiveTerms terms;
  std::optional<double> value;  ///< as simulated
  study::Estimate estimate;     ///< by the surrogate; empty for a formula, which is known exactly
};

/// How a constraint stands at a design.
struct ConstraintResult {
  std::string name;
  std::string metric;           ///< the metric's key; empty for a formula
  std::string expression;       ///< the formula; empty for a metric
  std::string statistic;        ///< over the scenarios, in words; empty where there is one event
  std::optional<double> value;  ///< empty: the metric has none
  std::optional<double> lower, upper;
  bool satisfied = false;
  std::optional<double> margin;          ///< to the nearer limit, negative outside
  std::optional<double> margin_percent;  ///< of that limit
  bool active = false;                   ///< holds by less than 2 % of the limit
};

/// Which end of its range a variable is at.
enum class Bound { none, lower, upper };

/// A variable with the range that the spec allows it.
struct VariableResult {
  std::string name;
  double value = 0.0, lower = 0.0, upper = 0.0;
  std::string option;                ///< of a choice: the one taken
  std::vector<std::string> options;  ///< of a choice: all; empty for a number
  Bound at_bound = Bound::none;      ///< within 1 % of the range
};

/// One design with all that is known of it.
struct DesignReport {
  std::string id;
  std::string stage;  ///< as in records::EvaluationRecord
  WrittenDesign design;
  std::vector<VariableResult> variables;
  double spacing = 0.0;                ///< particle spacing [m]
  std::vector<std::string> scenarios;  ///< that it was simulated under; empty: the base event
  std::optional<double> objective_scalar;
  std::vector<ObjectiveResult> objectives;
  std::vector<ConstraintResult> constraints;
  std::vector<solver::Metric> metrics;
  std::vector<records::TermRecord> terms = {};  ///< of the study
};

}  // namespace parapet::reports
