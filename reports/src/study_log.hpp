/// A study folder as it lies on the disk: study.json and evaluations.jsonl.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::reports {

/// One limit on a metric or an expression, with the value that a design reached.
struct LoggedConstraint {
  std::string name;
  std::string of;  ///< the metric's key or the expression, when the spec tells
  bool on_metric = false;
  std::optional<double> value;  ///< empty: the metric is absent
  std::optional<double> lower, upper;
  std::optional<double> scale;  ///< by which the spec divides a violation
  bool satisfied = false;

  /// Distance to the nearer limit, negative outside; empty without a value or a limit.
  std::optional<double> margin() const;
  /// The limit that margin() is measured from.
  std::optional<double> nearer_limit() const;
};

struct LoggedObjective {
  std::string metric;
  std::string goal;  ///< "maximize" or "minimize"
  double weight = 1.0;
  std::optional<double> value;  ///< what counted
  bool absent = false;          ///< the metric has no value: `value` stands in for it
};

/// One line of the log.
struct LoggedDesign {
  std::string id;
  std::string stage;  ///< as in EvaluationRecord
  designs::Design design;
  bool ok = false;
  std::string reason;  ///< why it failed
  std::vector<solver::Metric> metrics;
  std::vector<LoggedObjective> objectives;
  std::optional<double> objective_scalar;  ///< minimised; empty for a failed design
  std::vector<LoggedConstraint> constraints;
  bool feasible = false;
  std::optional<double> spacing;  ///< particle spacing [m]

  std::optional<double> metric(const std::string& key) const;
  /// Sum over the constraints of the distance outside, each over its scale (default: its limit).
  double violation() const;
};

struct LoggedVariable {
  std::string name;
  double lower = 0.0, upper = 0.0;
  bool choice = false;       ///< its value is the number of an option
  bool conditional = false;  ///< exists only under some options of a choice
};

struct StudyLog {
  std::string folder;
  std::filesystem::path path;  ///< of the study folder
  designs::Json spec;          ///< resolved
  designs::Json provenance;    ///< null when not recorded
  std::string spec_hash;
  std::vector<LoggedVariable> variables;
  std::vector<LoggedDesign> designs;
  bool incomplete_last_line = false;

  int barriers() const;  ///< of the base case; as many as the metrics name, at least
};

/// Designs at coarser particle spacings than the finest that is logged are left out: they served
/// the search, no advice rests on them.
/// @throws designs::InputError naming file and line of what is missing or damaged. A last line of
/// the log that is not complete is passed over.
StudyLog read_study_log(const std::filesystem::path& study_dir);

}  // namespace parapet::reports
