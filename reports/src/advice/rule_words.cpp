#include "rule_words.hpp"

#include <fmt/format.h>

#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

std::string knee_words(const study::Choice& choice) {
  if (choice.front.empty()) return "The knee of the front.";
  if (!choice.knee) {
    return "One design is at least as good as every other in every objective: there is nothing to "
           "trade off, and it is taken.";
  }
  const study::Knee& knee = *choice.knee;
  std::vector<std::string> ends;
  for (const std::size_t end : knee.ends) ends.push_back(choice.front[end].design->id);
  const std::string scaled =
      "The knee of the front: each objective is scaled to 0 at its best and 1 at its worst value "
      "on the front; ";
  std::string words =
      knee.through_ends
          ? fmt::format(
                "{}the design is taken that lies farthest, towards the best values, from "
                "the {} through the ends of the front (the designs best in each objective: "
                "{}).",
                scaled, knee.ends.size() == 2 ? "line" : "plane", joined(ends))
          : fmt::format(
                "{}the design is taken whose largest scaled objective is smallest (the designs "
                "best in each objective, {}, span no plane to measure a distance from).",
                scaled, joined(ends));
  if (choice.front.size() <= knee.ends.size()) {
    words +=
        " This front has no design between its ends, so the rule tells little here; the first "
        "objective decides between equals.";
  }
  return words;
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
    case study::RuleKind::automatic:
    case study::RuleKind::best:
      break;
  }
  return study.spec.objectives.size() > 1
             ? "The least weighted sum of the objectives, with the spec's own weights and scales."
             : "The best value of the objective among the designs that meet every constraint.";
}

}  // namespace parapet::reports
