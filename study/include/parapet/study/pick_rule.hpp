/// Which design of a study to take: the rule, and the order in which it ranks the designs.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/study/repeat.hpp"

namespace parapet::study {

/// How one design is picked from those that were found.
enum class RuleKind {
  automatic,  ///< best for one objective; of several the knee, else balanced
  best,       ///< lowest objective_scalar: the spec's weighted sum where there are several
  knee,       ///< farthest from the plane through the ends of the front
  weights,    ///< lowest weighted sum, each objective over its range on the front
  limits,     ///< best first objective among the designs that meet limits on objectives
  balanced    ///< least of the largest normalised objective; also where there is no knee
};

/// A rule's name on the command line.
std::string to_string(RuleKind kind);

/// A limit that an objective must meet, in its own unit.
struct ObjectiveLimit {
  std::string objective;
  std::optional<double> lower, upper;
};

/// A rule with its weights or limits.
struct PickRule {
  RuleKind kind = RuleKind::automatic;
  std::map<std::string, double> weights = {};  ///< by objective; 0 for those left out
  std::vector<ObjectiveLimit> limits = {};
};

/// Reads what the command line says: a rule's name ("" for automatic), "NAME=NUMBER,NAME=NUMBER"
/// and limits "NAME<=NUMBER" or "NAME>=NUMBER". Weights alone mean the rule weights, limits alone
/// the rule limits.
/// @throws designs::InputError naming the option
PickRule parse_pick_rule(const std::string& rule, const std::string& weights,
                         const std::vector<std::string>& limits);

/// The options that give the rule, each with a space before it; empty for the default.
std::string command_line(const PickRule& rule);

/// A text as one word of a shell's command line, in quotes where it needs them.
std::string shell_word(const std::string& text);

/// A design in the order of preference.
struct Pick {
  std::string id;
  designs::Design design;
  double spacing = 0.0;                        ///< at which it was observed [m]; 0: not known
  std::optional<double> probability_feasible;  ///< that a repeat meets every constraint
  /// What a run is predicted to give [n_objectives], by surrogates that have not seen it; empty
  /// where there is none.
  std::vector<std::optional<RepeatEstimate>> predicted = {};
};

}  // namespace parapet::study
