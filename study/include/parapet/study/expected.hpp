/// What a repeat of a built design would give: every goal of a study, and the loads to design for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/loaded_study.hpp"
#include "parapet/study/repeat.hpp"

namespace parapet::study {

/// What a number is to a study.
enum class Role { objective, constraint, load };

/// What a repeat of a design would give of one quantity.
struct Expectation {
  Role role = Role::objective;
  std::string name;    ///< of the objective or constraint; of a load its metric
  std::string metric;  ///< its key; empty for a formula
  std::size_t place =
      0;               ///< in the spec's objectives or constraints; of a load its barrier, from 1
  bool exact = false;  ///< a formula of the design: known without a run
  std::optional<double> lower, upper;      ///< of a constraint
  int absent = 0;                          ///< runs of the design in which it does not exist
  std::optional<RepeatEstimate> estimate;  ///< empty: no run has a value, and no surrogate
  std::optional<double> probability;       ///< of a constraint: that a repeat meets it
};

/// What the study's own runs and the surrogates say of each design, no run made since:
/// [n_designs][n_objectives, then the limits of the constraints]. Empty estimates' scatter: the
/// study has no surrogate.
std::vector<std::vector<Expectation>> predicted_expectations(
    const LoadedStudy& study, const std::vector<const records::EvaluationRecord*>& designs);

/// The same of one design with the runs of confirmations.jsonl, and the design force and moment of
/// each barrier (the highest of the scenarios). Runs count that were made at one spacing: the
/// finest at which the design or one near to it was simulated.
std::vector<Expectation> repeat_expectations(const LoadedStudy& study,
                                             const records::EvaluationRecord& design);

/// The spacing that repeat_expectations counts at [m].
double repeat_spacing(const LoadedStudy& study, const records::EvaluationRecord& design);

/// Probability that a repeat meets every constraint, these taken as independent; empty where one is
/// not known. 1 for a study without constraints.
std::optional<double> probability_all_met(const std::vector<Expectation>& expectations);

/// Margins are compared up to here: beyond it 99.9 % of repeats hold.
constexpr double most_margin = 3.0;

/// The least distance of a mean from its limit in standard uncertainties, at most most_margin;
/// empty without a constraint on a metric, or where the scatter of one is not known.
std::optional<double> margin_in_uncertainties(const std::vector<Expectation>& expectations);

/// Whether a study has a constraint that a simulation can break.
bool has_metric_constraint(const designs::StudySpec& study);

/// Whether an objective follows from the design alone.
bool is_exact(const designs::Objective& objective);

}  // namespace parapet::study
