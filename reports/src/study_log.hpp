/// A study folder as it lies on the disk: study.json and evaluations.jsonl.
#pragma once

#include <filesystem>
#include <map>
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
  std::string statistic;        ///< over the scenarios, in words; empty where there is one event
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
  std::string metric;  ///< its name in the log; by default the metric or the expression
  std::string of;      ///< the metric's key or the expression, when the spec tells; else the name
  std::string statistic;  ///< over the scenarios, in words; empty where there is one event
  bool on_metric = true;
  std::string goal;  ///< "maximize" or "minimize"
  double weight = 1.0;
  std::optional<double> value;  ///< what counted
  bool absent = false;          ///< the metric has no value: `value` stands in for it

  /// The value as something to be minimised.
  std::optional<double> minimised() const;
};

/// One line of the log.
struct LoggedDesign {
  std::string id;
  std::string stage;       ///< "start", "search", "external", ...
  designs::Design design;  ///< active variables; of a choice the option's number
  std::map<std::string, std::string> options;  ///< choice -> option taken
  bool ok = false;
  std::string reason;  ///< why it failed
  std::vector<solver::Metric> metrics;
  std::vector<LoggedObjective> objectives;
  std::optional<double> objective_scalar;  ///< minimised; empty for a failed design
  std::vector<LoggedConstraint> constraints;
  bool feasible = false;
  std::optional<double> spacing;       ///< particle spacing [m]
  double cpu_time = 0.0;               ///< [s]; 0: not known
  std::vector<std::string> scenarios;  ///< that it was simulated under; empty: the base event

  std::optional<double> metric(const std::string& key) const;
  /// Sum over the constraints of the distance outside, each over its scale (default: its limit).
  double violation() const;
};

struct LoggedVariable {
  std::string name;
  double lower = 0.0, upper = 0.0;  ///< of a choice: 0 and the number of options - 1
  bool integer = false;
  std::vector<std::string> options;  ///< of a choice
  bool conditional = false;          ///< exists under some choices only

  bool choice() const { return !options.empty(); }
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
  std::vector<LoggedDesign> confirmations;  ///< confirmations.jsonl, see confirmations.hpp
  designs::Json pareto;                     ///< pareto.json; null when there is none of this study
  designs::Json sensitivity;                ///< sensitivity.json; likewise

  int barriers() const;  ///< of the base case; as many as the metrics name, at least

  /// The particle spacing that counts: the finest of the spec at which a simulation ended well,
  /// else the finest of these. Empty when the spec names none: then all designs count [m].
  std::optional<double> counted_spacing() const;
  bool counts(const LoggedDesign& design) const;  ///< ok, with values, at that spacing

  /// Whether every variable is a number that exists in every design.
  bool all_numbers() const;

  std::size_t n_objectives() const;
};

/// @throws designs::InputError naming file and line of what is missing or damaged. A last line of
/// the log that is not complete is passed over.
StudyLog read_study_log(const std::filesystem::path& study_dir);

}  // namespace parapet::reports
