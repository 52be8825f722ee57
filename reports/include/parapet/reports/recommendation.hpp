/// From a study to advice: which arrangement to build, how sure, and what else would do.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parapet/reports/design_report.hpp"
#include "parapet/study/confirmation.hpp"
#include "parapet/study/expected.hpp"
#include "parapet/study/loaded_study.hpp"
#include "parapet/study/pick_rule.hpp"

namespace parapet::reports {

/// How many designs were simulated at a spacing.
struct SpacingCount {
  double spacing = 0.0;  ///< particle spacing [m]
  int designs = 0;       ///< that were simulated at it
  int feasible = 0;      ///< of these, that meet every constraint there
  int failed = 0;        ///< of these
};

/// What was studied, and how much was simulated for it.
struct StudyFacts {
  std::string folder;
  designs::StudySpec spec;
  std::vector<ObjectiveTerms> objectives;
  int evaluations = 0, failed = 0;  ///< designs, counted once at each spacing
  int feasible = 0;                 ///< likewise, that meet every constraint
  int simulations = 0;
  double cpu_time = 0.0;  ///< [s]; 0: not known
  bool log_complete = true;
  double counted_spacing = 0.0;  ///< of the designs that are compared [m]
  std::vector<SpacingCount> spacings;
  std::optional<study::EventBasis> events = {};  ///< of a study over a distribution of events
};

/// A design that the data cannot tell from the one that the rule puts first.
struct TiedDesign {
  std::string id;
  double share = 0.0;            ///< of the draws in which the rule takes it
  std::optional<double> margin;  ///< see study::margin_in_uncertainties
  std::optional<double> probability_feasible;
};

/// How the design was chosen.
struct RuleFacts {
  study::RuleKind kind = study::RuleKind::best;  ///< never automatic
  std::vector<study::ObjectiveLimit> limits;
  std::string words;                 ///< the rule, for a reader
  bool all_doubtful = false;         ///< no design that it allows is likely to meet the constraints
  bool allows_none = false;          ///< designs meet the constraints, and none of them its limits
  std::optional<double> share;       ///< of the draws of the front in which the rule takes this one
  int draws = 0;                     ///< of the surrogates' posterior; 0: there is none
  std::optional<double> bulge;       ///< rule knee: how far the knee is from the front's line
  bool no_knee = false;              ///< a knee was asked for, and the front has none
  std::optional<double> knee_share;  ///< of the draws in which it has one
  std::string first_by_rule;         ///< id, before ties were settled
  std::vector<TiedDesign> ties = {};  ///< with that one, the recommended design left out
};

/// The design that the rule picks.
struct RecommendedDesign {
  DesignReport design;
  std::vector<ObjectiveEstimate> estimates;
  std::optional<double> probability_feasible;  ///< that a repeat meets every constraint
  std::optional<double> probability_limits;    ///< that it meets the rule's limits
  /// What a repeat would give: objectives, limits of constraints on metrics, design loads.
  std::vector<study::Expectation> repeat = {};
  double repeat_spacing = 0.0;           ///< at which these runs were made [m]
  std::optional<double> margin = {};     ///< see study::margin_in_uncertainties, of the prediction
  std::vector<std::string> sketch = {};  ///< its barriers in characters
};

/// A simulation of the recommended design at another spacing, or of a design very near to it.
struct ConfirmingRun {
  std::string id;
  std::string stage;     ///< one of study::confirmation_stage
  double spacing = 0.0;  ///< particle spacing [m]
  bool ok = false;
  std::string reason;  ///< why it failed
  bool feasible = false;
  std::vector<std::optional<double>> objectives;  ///< [n_objectives]
  std::vector<std::string> violated;              ///< names of constraints
  std::vector<std::string> worse = {};            ///< objectives that are worse than was predicted
};

/// How far a quantity moves between the design and those near to it.
struct Spread {
  std::string name;    ///< of the objective or the constraint
  std::string metric;  ///< its metric
  int runs = 0;
  double least = 0.0, greatest = 0.0, standard_deviation = 0.0;
};

/// A design that the rule prefers and that did not hold.
struct RefutedDesign {
  std::string id;
  std::vector<std::string> violated;    ///< names of constraints
  std::vector<std::string> worse = {};  ///< objectives worse than predicted; both empty: it failed
};

/// What simulating the recommended design again has shown.
struct Confirmation {
  study::Verdict verdict = study::Verdict::none;
  std::vector<ConfirmingRun> runs;  ///< by id
  std::vector<Spread> spread;
  std::vector<RefutedDesign> refuted;  ///< in the rule's order
  bool constraints_tested = true;      ///< a constraint needs a simulation
  bool objectives_tested = false;      ///< surrogates predicted objectives of these runs
};

/// The design that comes nearest to meeting every constraint.
struct LeastViolatingDesign {
  DesignReport design;
  double violation = 0.0;  ///< see study::violation
};

/// A design of the Pareto set.
struct FrontDesign {
  std::string id;
  WrittenDesign design;
  std::vector<ObjectiveEstimate> objectives;
  std::optional<double> probability_feasible, probability_limits;
  bool within_limits = true;         ///< of the rule, as observed
  double score = 0.0;                ///< by the rule; less is better
  std::optional<double> share = {};  ///< of the draws in which the rule takes it
};

/// A step along the front.
struct FrontStep {
  std::string id;               ///< of the design at its end
  std::vector<double> changes;  ///< [n_objectives] in the objectives' units
};

/// What it takes to be better in one objective.
struct WayOut {
  std::size_t objective = 0;
  FrontStep next;  ///< to the nearest design that is better in it
  FrontStep best;  ///< to the best one
};

/// How the hypervolume of the front grew.
struct Progress {
  std::optional<double> hypervolume;
  std::vector<std::optional<double>> reference;  ///< [n_objectives]
  std::vector<study::FrontEntry> history;
};

/// What one objective gained over the starting design.
struct ObjectiveChange {
  std::string name;
  std::string of;  ///< the metric or the formula
  designs::Goal goal = designs::Goal::maximize;
  std::optional<double> start, best, change, change_percent;
  std::optional<bool> better;
};

/// The recommended design against the best starting design.
struct Improvement {
  std::string start_id;
  bool start_feasible = false;
  bool same_design = false;
  WrittenDesign start_design;
  std::optional<double> scalar_start, scalar_best;
  std::vector<ObjectiveChange> objectives;
};

/// A design that comes next to the recommended one.
struct Alternative {
  DesignReport design;
  /// One objective: the data cannot rank it against the recommended design.
  std::optional<bool> within_scatter;
};

/// What a fit says of one variable, over the span in which it was tried.
struct VariableResponse {
  std::string variable;
  double tried_from = 0.0, tried_to = 0.0;
  std::optional<double> change, standard_error, standardised, bend;  ///< see VariableEffect
  bool clear = false;  ///< an effect beyond its 95 % interval
  std::optional<double> correlation;
  std::string says;  ///< one sentence, no stronger than the data
};

/// What each variable does to a metric that the study asks about: a least-squares fit.
struct MetricResponse {
  std::string metric;
  int points = 0;
  std::string model;
  std::optional<double> r2, r2_left_out, scatter;  ///< empty without a fit
  std::string verdict;
  std::vector<VariableResponse> variables;
};

/// A design whose simulation failed.
struct FailedDesign {
  std::string id;
  WrittenDesign design;
  std::string reason;
};

/// Commands that repeat the study, its recommendation and the design.
struct Reproduction {
  std::string evaluate, optimize, recommend;
  std::string spec;  ///< where the spec is, in words
  std::string spec_hash;
  designs::Json provenance;  ///< as study.json states it
};

/// Everything that a recommendation says, as numbers and texts.
struct Recommendation {
  StudyFacts study;
  RuleFacts rule;
  std::optional<RecommendedDesign> recommended;  ///< empty: no design meets every constraint, or
                                                 ///< none of them the rule's limits
  std::optional<Confirmation> confirmation;      ///< of the recommended design
  std::optional<LeastViolatingDesign> least_violating;  ///< when no design meets every constraint
  std::vector<FrontDesign> front;                       ///< for several objectives
  std::vector<WayOut> leaving;                          ///< likewise: from the recommended design
  std::optional<Progress> progress;                     ///< likewise: of the search
  std::optional<Improvement> improvement;
  std::vector<Alternative> alternatives;
  std::vector<MetricResponse> effects;  ///< empty where a variable is a choice or hangs on one
  std::optional<study::Sensitivity> sensitivity;
  std::vector<FailedDesign> failed;
  std::vector<std::string> caveats;
  std::optional<Reproduction> reproduce;  ///< of the recommended or the least violating design
  std::vector<std::pair<std::string, std::string>> definitions;  ///< metric key, what it means

  /// The design to show: recommended, else least violating, else null.
  const DesignReport* shown() const;
};

/// Nothing is simulated or written. Of the designs that the rule ranks, the first is recommended
/// that no confirmation has refuted.
/// @throws designs::InputError when the rule does not fit the study's objectives
Recommendation recommend(const study::LoadedStudy& study, const study::PickRule& rule = {});

}  // namespace parapet::reports
