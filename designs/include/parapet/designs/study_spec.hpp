/// A study: which inputs may vary, what is wanted, and how to search.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/case_spec.hpp"

namespace parapet::designs {

/// A value for each design variable, keyed by the variable's name (which carries its unit).
using Design = std::map<std::string, double>;

/// One input of the case that may vary.
struct Variable {
  std::string name;                  ///< for example deflector_angle_deg
  std::vector<std::string> targets;  ///< JSON pointers into the case that take its value
  double lower = 0.0;
  double upper = 0.0;
};

enum class Goal { maximize, minimize };

/// A metric that is to be maximised or minimised.
struct Objective {
  std::string metric;
  Goal goal = Goal::maximize;
  double weight = 1.0;
  double scale = 1.0;                       ///< the metric is divided by it before weighting
  std::optional<double> value_when_absent;  ///< used (and logged as such) when there is no value
};

/// lower <= value <= upper, on a metric (needs a simulation) or on an expression of the design
/// variables (tested before one is run).
struct Constraint {
  std::string name;
  std::string metric;      ///< empty for an expression
  std::string expression;  ///< in the variables' names; empty for a metric
  std::optional<double> lower;
  std::optional<double> upper;
  double scale = 1.0;                 ///< violation is divided by it; default: |limit| or 1
  bool satisfied_when_absent = true;  ///< a metric without a value
};

/// How to search: an NLopt algorithm by name.
struct Method {
  std::string algorithm = "COBYLA";  ///< NLopt's name without the prefix: COBYLA, BOBYQA, ISRES...
  std::string local_algorithm;       ///< for MLSL and AUGLAG; empty for the default
  int max_evaluations = 40;          ///< simulations, starting designs included
  double max_time_s = 0.0;           ///< 0: no limit
  double relative_tolerance = 1e-3;  ///< on the variables, as a share of their range
  std::uint64_t seed = 1;
  std::vector<Design> starts;  ///< starting designs given by the user
  int start_count = 0;         ///< further ones from a Sobol' sequence over the bounds
  double initial_step = 0.25;  ///< share of each range
};

struct StudySpec {
  std::string name;
  std::string description;
  Json base_case;  ///< resolved case JSON; the variables' values replace theirs
  std::vector<Variable> variables;
  std::vector<Objective> objectives;
  std::vector<Constraint> constraints;
  Method method;
  Json resolved;  ///< everything with defaults written out
  std::string source_file;
};

/// @throws InputError with every issue found.
StudySpec parse_study(const Json& json, const std::string& file);
StudySpec load_study(const std::filesystem::path& file);

/// The case of one design: the values go to the variables' targets, then the case is checked.
/// Bounds are not enforced here (`check_design` does).
/// @throws InputError when the scene is impossible.
CaseSpec design_case(const StudySpec& study, const Design& design);

/// Missing, unknown and out-of-bounds variables. Empty when sound.
std::vector<InputIssue> check_design(const StudySpec& study, const Design& design,
                                     const std::string& source);

/// Value of a design expression (muParser), the variables' names being its symbols.
/// @throws InputError when it cannot be evaluated.
double evaluate_expression(const std::string& expression, const Design& design);

/// Stable 64-bit hash of a resolved JSON document as 16 hex digits (FNV-1a of its compact dump).
std::string spec_hash(const Json& json);

/// A sweep: a list of cases that share a base (designs/table3.json).
struct SweepRow {
  std::string id;
  std::string description;
  CaseSpec spec;
  Json published;  ///< what the source states for this row: metric key -> value or range, with
                   ///< the sentence's place; null when nothing
};
struct SweepSpec {
  std::string name;
  std::string source;
  std::vector<SweepRow> rows;
  Json resolved;
};
SweepSpec load_sweep(const std::filesystem::path& file);
SweepSpec parse_sweep(const Json& json, const std::string& file);

/// The shipped specs, embedded in the program: quickstart, table3, ... nullptr when unknown.
const char* embedded_spec(const std::string& name);

/// Their names.
std::vector<std::string> embedded_spec_names();

/// A JSON schema (draft-07) by kind: case, study or sweep; nullptr when unknown.
const char* embedded_schema(const std::string& kind);

}  // namespace parapet::designs
