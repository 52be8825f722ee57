/// The designs of a study in the order in which a rule prefers them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "front.hpp"
#include "parapet/study/pick_rule.hpp"
#include "study_log.hpp"

namespace parapet::reports {

/// From here on a design meets its constraints rather than not, by the surrogate.
constexpr double least_probability = 0.5;

struct Candidate {
  const LoggedDesign* design = nullptr;
  ObjectiveValues values = {};   ///< [n_objectives], to be minimised
  designs::Json view = nullptr;  ///< its entry in pareto.json; null when there is none
  double score = 0.0;            ///< by the rule; less is better
  std::optional<double> probability_limits = {};  ///< rule limits: that it meets them
  bool within_limits = true;                      ///< rule limits: as observed

  std::optional<double> probability_feasible() const;
  /// Known to be less likely than not to meet every constraint.
  bool doubtful() const;
};

struct Choice {
  study::RuleKind kind = study::RuleKind::best;  ///< never automatic
  std::string words;                             ///< the rule, for a reader
  std::vector<Candidate> ranked;                 ///< what the rule allows, best first
  std::vector<Candidate> front;                  ///< the Pareto set, best first objective first
  /// Every design that the surrogate knows is doubtful.
  bool all_doubtful = false;

  const LoggedDesign* first() const { return ranked.empty() ? nullptr : ranked.front().design; }
};

/// @throws designs::InputError for a rule that does not fit the study's objectives
Choice choose(const StudyLog& log, const study::PickRule& rule);

/// The probability that objective j is within the limit, by its estimate and interval in
/// pareto.json: each side of the median is taken as half of a normal distribution. Empty without an
/// estimate.
std::optional<double> probability_within(const designs::Json& objective,
                                         const study::ObjectiveLimit& limit);

/// A rule's name on the command line.
std::string to_string(study::RuleKind kind);

}  // namespace parapet::reports
