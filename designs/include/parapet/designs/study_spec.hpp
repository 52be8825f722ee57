/// A study: which inputs may vary, what is wanted, and how to search.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/case_spec.hpp"

namespace parapet::designs {

/// A value for each active design variable, keyed by the variable's name (which carries its unit).
/// A choice holds the number of its option, from 0. A variable that does not exist under the
/// options taken is not in the map.
using Design = std::map<std::string, double>;

/// What values a variable may take: any between its bounds, whole numbers, or options.
enum class VariableKind { continuous, integer, choice };

/// One option of a choice: what it changes in the case, removals first.
struct Option {
  std::string name;                  ///< for example "plate" or "none"
  std::vector<std::string> removes;  ///< JSON pointers into the case, in the order of removal
  std::map<std::string, Json> sets;  ///< JSON pointer into the case -> value
};

/// A variable exists only when an earlier choice has taken one of these options.
struct ActiveWhen {
  std::string choice;
  std::vector<int> options;
};

/// One input of the case that may vary.
struct Variable {
  std::string name;  ///< for example deflector_angle_deg
  /// JSON pointers into the case that take its value. /barriers/N/... is the last of at least two
  /// barriers and /barriers/*/... each one, where that differs between combinations of options.
  std::vector<std::string> targets;
  double lower = 0.0;  ///< of a choice: 0
  double upper = 0.0;  ///< of a choice: the number of options - 1
  VariableKind kind = VariableKind::continuous;
  std::vector<Option> options = {};  ///< of a choice
  std::optional<ActiveWhen> active_when = {};
};

/// How one number is made of a metric's values over the scenarios, which have weights.
enum class Statistic {
  mean,
  worst,       ///< the least of what is maximised or has a lower limit, else the greatest
  quantile,    ///< the `quantile` of the weighted values, counted from the good end: 0.9 is the
               ///< value that 90 % of the events meet or better
  probability  ///< weight of the scenarios in which the metric is within the limits
};

/// Which way an objective is better.
enum class Goal { maximize, minimize };

/// A named expression: of the design variables, of metrics and of other terms. Objectives,
/// constraints and other terms may use its name.
struct Term {
  std::string name;                                  ///< ends in its unit
  std::string expression;                            ///< as given
  std::string formula;                               ///< with the terms that it uses written out
  std::vector<std::string> metrics;                  ///< that the formula uses
  std::map<std::string, double> values_when_absent;  ///< metric -> value where it does not exist
};

/// A metric, or an expression of design variables, metrics and terms, that is to be maximised or
/// minimised.
struct Objective {
  std::string metric;  ///< empty for an expression
  Goal goal = Goal::maximize;
  double weight = 1.0;
  double scale = 1.0;                       ///< the metric is divided by it before weighting
  std::optional<double> value_when_absent;  ///< used (and logged as such) when there is no value
  std::string name = {};                    ///< in reports; default: the metric or the expression
  std::string expression = {};              ///< as given; empty for a metric
  Statistic statistic = Statistic::mean;
  double quantile = 0.9;
  std::optional<double> lower = {}, upper = {};  ///< of the statistic probability
  std::optional<double> reference = {};          ///< of the hypervolume, in the objective's unit
  std::string formula = {};                      ///< the expression with its terms written out
  std::vector<std::string> metrics = {};         ///< that the expression uses
  /// Of the expression's metrics: metric -> value where it does not exist.
  std::map<std::string, double> values_when_absent = {};

  /// Whether it is a formula of the design variables alone, which needs no simulation.
  bool is_of_design() const { return metric.empty() && metrics.empty(); }
};

/// lower <= value <= upper, on a metric or on an expression of design variables, metrics and terms.
/// One of the design variables alone is tested before a simulation is run.
struct Constraint {
  std::string name;
  std::string metric;      ///< empty for an expression
  std::string expression;  ///< as given; empty for a metric
  std::optional<double> lower;
  std::optional<double> upper;
  double scale = 1.0;                 ///< violation is divided by it; default: |limit| or 1
  bool satisfied_when_absent = true;  ///< a metric without a value
  std::optional<double> value_when_absent = {};  ///< stands for the metric where it has no value
  /// Over the scenarios. worst: every scenario must meet the limits. probability: a share of at
  /// least `quantile` must.
  Statistic statistic = Statistic::worst;
  double quantile = 0.9;
  std::string formula = {};               ///< the expression with its terms written out
  std::vector<std::string> metrics = {};  ///< that the expression uses
  /// Of the expression's metrics: metric -> value where it does not exist.
  std::map<std::string, double> values_when_absent = {};

  /// Whether it limits a formula of the design variables alone, which needs no simulation.
  bool is_of_design() const { return metric.empty() && metrics.empty(); }
};

/// One event that every design is judged under: changes to the base case.
struct Scenario {
  std::string name;
  double weight = 1.0;                 ///< all weights together are 1
  std::map<std::string, double> sets;  ///< JSON pointer into the case -> value
};

/// One input that differs between events drawn from distributions, in the unit of its name.
struct EventVariable {
  std::string name;
  std::vector<double> at;     ///< [n_events] in the study's scenarios
  std::vector<double> draws;  ///< [n_event_draws] in further events of the same distributions
};

/// Number of events of the same distributions over which statistics are stated, by a Latin
/// hypercube of a seed of its own.
constexpr std::size_t n_event_draws = 2000;

/// Confidence with which a statistic of listed events must bound the true one.
constexpr double event_confidence = 0.95;

/// Confidence with which the worst of n events, drawn at random, bounds the value that a share q of
/// all events meet or better: 1 - q^n.
double worst_confidence(double quantile, std::size_t n_events);

/// A particle spacing at which designs may be simulated.
struct FidelityLevel {
  double spacing = 0.0;                 ///< [m]
  std::optional<double> seconds;        ///< CPU time of one simulation, if known [s]
  std::map<std::string, double> noise;  ///< metric -> standard deviation, in the metric's unit
};

/// How an NLopt algorithm, which knows one objective, is given several.
enum class Scalarization { weighted_sum, epsilon_constraint, augmented_chebyshev };

/// How to search.
struct Method {
  /// BAYESIAN; NLopt's name without the prefix (COBYLA, BOBYQA, ISRES...); or a design of
  /// experiments: SOBOL, LATIN_HYPERCUBE, FULL_FACTORIAL, LIST (the starts and nothing else).
  std::string algorithm = "BAYESIAN";
  std::string local_algorithm;       ///< for MLSL and AUGLAG; empty for the default
  int max_evaluations = 40;          ///< designs, starting ones included
  double max_time_s = 0.0;           ///< wall time; 0: no limit
  double relative_tolerance = 1e-3;  ///< on the variables, as a share of their range
  std::uint64_t seed = 1;
  std::vector<Design> starts;   ///< starting designs given by the user
  int start_count = 0;          ///< further ones from a Sobol' sequence over the bounds
  double initial_step = 0.25;   ///< share of each range
  double max_cpu_time_s = 0.0;  ///< sum over all simulations; 0: no limit
  Scalarization scalarization = Scalarization::weighted_sum;
  int pareto_points = 5;           ///< scalarised problems that share the budget
  int points_per_variable = 3;     ///< FULL_FACTORIAL
  int stagnation_evaluations = 0;  ///< BAYESIAN: stop after so many without a gain; 0: never
  double least_gain = 0.0;         ///< BAYESIAN: stop below this expected share of the hypervolume
  /// The same designs in the same order for the same jobs, however fast each simulation is.
  bool repeatable = true;
  /// Largest cost of all simulations, in particle steps over those of the mean simulation at the
  /// finest spacing; 0: no limit.
  double max_finest_runs = 0.0;
};

/// Which designs of a study are simulated once more at its end, to be looked at.
enum class Recordings {
  none,
  front,  ///< the Pareto set; of one objective the best design and the best start
  all     ///< all that ended well at the finest spacing
};

/// The base event of a study without barriers, simulated once.
struct UndisturbedFlow {
  solver::Scene scene;  ///< without barriers
  solver::GaugeSettings gauges;
  solver::ApproachProfile profile;

  /// Whether a case has the same event and the same gauges, so that it holds for its barriers.
  bool fits(const CaseSpec& spec) const;
};

/// A parsed study file, checked and with every default filled in.
struct StudySpec {
  std::string name;
  std::string description;
  Json base_case;  ///< resolved case JSON; the variables' values replace theirs
  std::vector<Variable> variables;
  std::vector<Objective> objectives;
  std::vector<Constraint> constraints;
  std::vector<Scenario> scenarios;      ///< empty: the base case is the only event
  std::vector<FidelityLevel> fidelity;  ///< at least one, finest (smallest spacing) first
  Method method;
  Recordings recordings = Recordings::front;
  Json resolved;  ///< everything with defaults written out
  std::string source_file;
  std::vector<Term> terms = {};  ///< in the order of their names
  /// Of scenarios that are drawn from distributions; empty for listed ones.
  std::vector<EventVariable> event_variables = {};
  /// No part of the file: where it is known, design_case() gives each case its `approach`.
  std::shared_ptr<const UndisturbedFlow> undisturbed = nullptr;
};

/// method.algorithm in upper case.
std::string algorithm_name(const StudySpec& study);

/// How a study searches.
enum class SearchKind {
  bayesian,
  experiments,  ///< SOBOL, LATIN_HYPERCUBE, FULL_FACTORIAL, LIST
  scalarized,   ///< NLopt, several problems with one objective each
  weighted_sum  ///< NLopt
};

/// What the algorithm's name stands for.
SearchKind search_kind(const StudySpec& study);

/// Whether max_evaluations decides which designs are asked for, not only how many: a Latin
/// hypercube of more designs is another one, and so are scalarised problems that share a larger
/// budget.
bool is_laid_out_for_budget(const StudySpec& study);

/// The finest particle spacing of a study: the one that counts [m].
double finest_spacing(const StudySpec& study);

/// Reads and checks a study. `file` only names the source in messages.
/// @throws InputError with every issue found.
StudySpec parse_study(const Json& json, const std::string& file);

/// The same with the file read from disk.
StudySpec load_study(const std::filesystem::path& file);

/// The case of one design: the options of choices are applied in the order of the variables, then
/// the values go to the variables' targets, then a scenario's to its own (null: the base event),
/// and then the spacing; the case is checked. Bounds are not enforced here (`check_design` does).
/// @throws InputError when the scene is impossible.
CaseSpec design_case(const StudySpec& study, const Design& design,
                     const Scenario* scenario = nullptr, std::optional<double> spacing = {});

/// The option numbers of a design in words: choice -> option's name.
std::map<std::string, std::string> option_names(const StudySpec& study, const Design& design);

/// Whether a variable exists under the options that a design takes.
bool is_active(const StudySpec& study, const Variable& variable, const Design& design);

/// A design as people write it, {"deflector_angle_deg": 45, "deflector": "plate"}: a number for
/// each active variable, an option's name for each active choice. The issues are those of
/// check_design, and texts or numbers where the other belongs; the design holds what is sound.
struct DesignReading {
  Design design;
  std::vector<InputIssue> issues;
};

/// Reads and checks such a design. `source` only names the source in the issues.
DesignReading read_design(const StudySpec& study, const Json& json, const std::string& source);

/// The design in that form: the inverse of read_design.
Json design_json(const StudySpec& study, const Design& design);

/// Missing, unknown and out-of-bounds variables, choices that are no option's number, inactive
/// variables that are given. Empty when sound.
std::vector<InputIssue> check_design(const StudySpec& study, const Design& design,
                                     const std::string& source);

/// Value of a design expression (muParser), the variables' names being its symbols.
/// @throws InputError when it cannot be evaluated.
double evaluate_expression(const std::string& expression, const Design& design);

/// An expression made ready to be evaluated many times. One thread at a time may use it.
class Formula {
 public:
  /// @param names of its symbols; those that it does not use are no harm
  /// @throws InputError when it cannot be read.
  Formula(const std::string& expression, const std::vector<std::string>& names);
  ~Formula();
  Formula(Formula&&) noexcept;             ///< may be moved, not copied
  Formula& operator=(Formula&&) noexcept;  ///< likewise

  /// @param values [n_names] in the order of the names
  /// @return not finite where the formula has no value
  double value(const std::vector<double>& values);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

/// The same for a study's objective or constraint: variables that are not active in the design
/// count as 0, choices as their option's number.
double evaluate_expression(const StudySpec& study, const std::string& expression,
                           const Design& design);

/// Stable 64-bit hash of a resolved JSON document as 16 hex digits (FNV-1a of its compact dump).
std::string spec_hash(const Json& json);

/// A study's spec that an earlier version has resolved, for comparison with the same study of now:
/// defaults that are others today are left out where `now` does not ask for the former value.
Json without_former_defaults(Json stored, const Json& now);

/// What an earlier version wrote, with the metrics' names of now, in keys and texts:
/// barrier_1_peak_force_n_per_m is called barrier_1_slam_force_n_per_m.
Json with_present_names(const Json& stored);

/// The text with the names of now.
std::string with_present_names(std::string text);

/// A sweep: a list of cases that share a base (designs/table3.json).
struct SweepRow {
  std::string id;
  std::string description;
  CaseSpec spec;
  Json published;  ///< what the source states for this row: metric key -> value or range, with
                   ///< the sentence's place; null when nothing
};

/// A parsed sweep file.
struct SweepSpec {
  std::string name;
  std::string source;
  std::vector<SweepRow> rows;
  Json resolved;
};

/// Reads and checks a sweep. `file` only names the source in messages.
/// @throws InputError with every issue found.
SweepSpec parse_sweep(const Json& json, const std::string& file);

/// The same with the file read from disk.
SweepSpec load_sweep(const std::filesystem::path& file);

/// The shipped specs, embedded in the program: quickstart, table3, ... nullptr when unknown.
const char* embedded_spec(const std::string& name);

/// Their names.
std::vector<std::string> embedded_spec_names();

/// A JSON schema (draft-07) by kind: case, study or sweep; nullptr when unknown.
const char* embedded_schema(const std::string& kind);

}  // namespace parapet::designs
