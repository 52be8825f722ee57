/// The designs of a study in the order in which a rule prefers them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/confirmation.hpp"
#include "parapet/study/expected.hpp"
#include "parapet/study/knee.hpp"
#include "parapet/study/loaded_study.hpp"
#include "parapet/study/pick_rule.hpp"

namespace parapet::study {

/// From here on a design meets its constraints rather than not.
constexpr double least_probability = 0.5;

/// Two designs are tied when the rule prefers either in at least this share of the draws.
constexpr double tie_share = 0.05;

/// A comparable design that meets every constraint as observed. Points into the study.
struct Candidate {
  const records::EvaluationRecord* design = nullptr;
  std::vector<double> values = {};                ///< [n_objectives] observed, to be minimised
  const DesignEstimates* estimates = nullptr;     ///< of pareto.json; null when there are none
  double score = 0.0;                             ///< by the rule; less is better
  std::optional<double> probability_limits = {};  ///< rule limits: that it meets them
  bool within_limits = true;                      ///< rule limits: as observed
  /// [n_objectives] to be minimised: by the surrogate, where there is one, else as observed.
  std::vector<double> expected = {};
  /// What a run of it is predicted to give: goals and limits. See predicted_expectations.
  std::vector<Expectation> predicted = {};
  std::optional<double> margin = {};  ///< see margin_in_uncertainties; of the prediction
  std::optional<double> share = {};   ///< of the draws in which the rule takes it
  std::optional<double> beats = {};   ///< of the draws in which the rule prefers it to the first

  /// That a repeat meets every constraint, by the surrogates; by pareto.json where surrogates.json
  /// is missing; empty without either.
  std::optional<double> probability_feasible() const;
  /// Known to be less likely than not to meet every constraint.
  bool doubtful() const;
};

/// The designs as a rule ranks them.
struct Choice {
  RuleKind kind = RuleKind::best;         ///< never automatic
  std::vector<Candidate> ranked = {};     ///< what the rule allows, best first
  std::vector<Candidate> front = {};      ///< the Pareto set, best first objective first
  std::optional<Knee> knee = {};          ///< of the front, where a knee was asked for and that has
                                          ///< several designs
  bool all_doubtful = false;              ///< every design that the surrogate knows is doubtful
  bool no_knee = false;                   ///< a knee was asked for, and the front has none
  std::optional<double> knee_share = {};  ///< of the draws in which the front has a knee
  int draws = 0;                          ///< of the surrogates' posterior; 0 without one
  /// Ids of the designs that the draws cannot tell from the one the rule puts first, in its order.
  /// Of these and of that one, the one with the largest margin stands first in `ranked`.
  std::vector<std::string> tied = {};
  std::string first_by_rule = {};  ///< id; empty when nothing is ranked
};

/// Ranks by the rule, on what the surrogates expect of each design; designs that they doubt come
/// last, unless they doubt all. Ties within the uncertainty go to the design with the largest
/// margin. A front without a knee (see least_bulge; or fewer than half of the draws have one) is
/// ranked by the rule balanced. Runs of confirmations.jsonl have no part in it.
/// @param study must outlive the result
/// @throws designs::InputError for a rule that does not fit the study's objectives
Choice choose(const LoadedStudy& study, const PickRule& rule);

/// The ranked designs of choose(), as confirm_picks takes them.
/// @throws designs::InputError likewise
std::vector<Pick> ranked_picks(const LoadedStudy& study, const PickRule& rule);

/// A candidate as confirm_picks takes it.
Pick pick_of(const Candidate& candidate);

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
