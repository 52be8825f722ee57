#include "rule_words.hpp"

#include <fmt/format.h>

#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

constexpr const char* scaled_words =
    "each objective is scaled to 0 at its best and 1 at its worst value on the front; ";

std::string ends_of(const study::Choice& choice) {
  std::vector<std::string> ends;
  for (const std::size_t end : choice.knee->ends) ends.push_back(choice.front[end].design->id);
  return joined(ends);
}

std::string knee_words(const study::Choice& choice) {
  if (choice.front.empty()) return "The knee of the front.";
  if (!choice.knee) {
    return "One design is at least as good as every other in every objective: there is nothing to "
           "trade off, and it is taken.";
  }
  std::string words = fmt::format(
      "The knee of the front: {}the design is taken that lies farthest, towards the best values, "
      "from the {} through the ends of the front (the designs best in each objective: {}). It is "
      "{:.2f} off; a front counts as one with a knee from {:g} on.",
      scaled_words, choice.knee->ends.size() == 2 ? "line" : "plane", ends_of(choice),
      study::bulge_of(*choice.knee), study::least_bulge);
  if (choice.knee_share) {
    words += fmt::format(" Of {} draws of the surrogates, {:.0f} % have a knee.", choice.draws,
                         100.0 * *choice.knee_share);
  }
  return words;
}

std::string balanced_words(const study::Choice& choice) {
  const std::string rule = fmt::format(
      "{}the design is taken whose largest scaled objective is smallest.", scaled_words);
  if (!choice.no_knee) return "Balanced: " + rule;
  std::string why;
  if (!choice.knee->through_ends) {
    why = fmt::format("the designs best in each objective, {}, span no plane to measure from",
                      ends_of(choice));
  } else if (choice.front.size() <= choice.knee->ends.size()) {
    why = "no design lies between its ends";
  } else {
    const char* through = choice.knee->ends.size() == 2 ? "line" : "plane";
    const double bulge = study::bulge_of(*choice.knee);
    why = bulge < study::least_bulge
              ? fmt::format(
                    "it is nearly straight (its farthest design is {:.2f} off the {} through "
                    "its ends, {}; a knee needs {:g})",
                    bulge, through, ends_of(choice), study::least_bulge)
              : fmt::format(
                    "its farthest design is expected to be {:.2f} off the {} through its "
                    "ends, {}, but only {:.0f} % of {} draws have a design that is {:g} off",
                    bulge, through, ends_of(choice), 100.0 * choice.knee_share.value_or(0.0),
                    choice.draws, study::least_bulge);
  }
  return fmt::format("The front has no knee: {}. So the balanced design is taken: {}", why, rule);
}

std::string weights_words(const study::LoadedStudy& study, const study::PickRule& rule) {
  std::vector<std::string> words;
  for (const auto& [name, weight] : rule.weights) {
    words.push_back(fmt::format("{} {:g}", key_words(name), weight));
  }
  const bool some_left_out = rule.weights.size() < study.spec.objectives.size();
  return fmt::format(
      "Weights: each objective is scaled to 0 at its best and 1 at its worst value on the front; "
      "the design with the least weighted sum is taken (weights: {}{}).",
      joined(words), some_left_out ? "; 0 for the others" : "");
}

std::string limits_words(const study::PickRule& rule) {
  std::vector<std::string> words;
  for (const study::ObjectiveLimit& limit : rule.limits) {
    words.push_back(key_words(limit.objective) +
                    (limit.upper ? " at most " + with_unit(limit.upper, limit.objective)
                                 : " at least " + with_unit(limit.lower, limit.objective)));
  }
  return fmt::format(
      "Limits: of the designs on the front with {}, the one best in the first objective is taken.",
      joined(words));
}

}  // namespace

std::string rule_words(const study::LoadedStudy& study, const study::PickRule& rule,
                       const study::Choice& choice) {
  switch (choice.kind) {
    case study::RuleKind::knee:
      return knee_words(choice);
    case study::RuleKind::weights:
      return weights_words(study, rule);
    case study::RuleKind::limits:
      return limits_words(rule);
    case study::RuleKind::balanced:
      return balanced_words(choice);
    case study::RuleKind::automatic:
    case study::RuleKind::best:
      break;
  }
  return study.spec.objectives.size() > 1
             ? "The least weighted sum of the objectives, with the spec's own weights and scales."
             : "The best value of the objective among the designs that meet every constraint, as "
               "the "
               "surrogate expects it where there is one.";
}

}  // namespace parapet::reports
