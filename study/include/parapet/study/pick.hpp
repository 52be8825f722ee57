/// The designs of a study in the order in which a rule prefers them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/confirmation.hpp"
#include "parapet/study/knee.hpp"
#include "parapet/study/loaded_study.hpp"
#include "parapet/study/pick_rule.hpp"

namespace parapet::study {

/// From here on a design meets its constraints rather than not, by the surrogate.
constexpr double least_probability = 0.5;

/// A comparable design that meets every constraint as observed. Points into the study.
struct Candidate {
  const records::EvaluationRecord* design = nullptr;
  std::vector<double> values = {};                ///< [n_objectives], to be minimised
  const DesignEstimates* estimates = nullptr;     ///< by the surrogate; null when there are none
  double score = 0.0;                             ///< by the rule; less is better
  std::optional<double> probability_limits = {};  ///< rule limits: that it meets them
  bool within_limits = true;                      ///< rule limits: as observed

  /// That every constraint is met, by the surrogate; empty without one.
  std::optional<double> probability_feasible() const;
  /// Known to be less likely than not to meet every constraint.
  bool doubtful() const;
};

/// The designs as a rule ranks them.
struct Choice {
  RuleKind kind = RuleKind::best;      ///< never automatic
  std::vector<Candidate> ranked = {};  ///< what the rule allows, best first
  std::vector<Candidate> front = {};   ///< the Pareto set, best first objective first
  std::optional<Knee> knee = {};       ///< rule knee: of the front, where that has several designs
  bool all_doubtful = false;           ///< every design that the surrogate knows is doubtful
};

/// Ranks by the rule; designs that the surrogate doubts come last, unless it doubts all.
/// @param study must outlive the result
/// @throws designs::InputError for a rule that does not fit the study's objectives
Choice choose(const LoadedStudy& study, const PickRule& rule);

/// The ranked designs of choose(), as confirm_picks takes them.
/// @throws designs::InputError likewise
std::vector<Pick> ranked_picks(const LoadedStudy& study, const PickRule& rule);

/// The probability that an objective is within the limit: each side of the surrogate's median is
/// taken as half of a normal distribution. Empty without an estimate.
std::optional<double> probability_within(const Estimate& estimate, const ObjectiveLimit& limit);

/// What confirmations.jsonl says of the designs that a rule ranks first.
struct ConfirmedPick {
  const Candidate* pick = nullptr;             ///< null when nothing is ranked
  Verdict verdict = Verdict::none;             ///< of the pick
  std::vector<const Candidate*> refuted = {};  ///< that the rule prefers, in its order
};

/// The first design that is not refuted, among the first `most_confirmed_designs`; when all of
/// these are refuted, the rule's first again. Points into the choice.
ConfirmedPick confirmed_pick(const LoadedStudy& study, const Choice& choice);

}  // namespace parapet::study
