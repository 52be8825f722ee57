#include "opening_text.hpp"

#include <fmt/format.h>

#include "design_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

std::string objective_words(const ObjectiveResult& objective) {
  const std::string value = objective_value(objective.terms, objective.value);
  return objective.absent ? fmt::format("no value, counted as {}", value) : value;
}

std::string opening_without_pick(const Recommendation& advice) {
  const StudyFacts& study = advice.study;
  std::string text = fmt::format("# No arrangement to recommend: {}\n\n", study.spec.name);
  if (advice.rule.allows_none) {
    return text + fmt::format(
                      "**{} designs meet every constraint, but none of them the rule's limits on "
                      "objectives.** {} The front below shows what can be had.\n\n",
                      study.feasible, advice.rule.words);
  }
  text += fmt::format("**None of the {} designs evaluated meets every constraint.** ",
                      study.evaluations);
  if (!advice.least_violating) return text + "No simulation succeeded either.\n\n";
  const DesignReport& nearest = advice.least_violating->design;
  return text + fmt::format(
                    "The one that misses them least is design {}: {}. It is shown below "
                    "to help in changing the spec, not as advice to build it.\n\n",
                    nearest.id, design_words(nearest.design));
}

/// One line on how sure the pick is; the section "How sure" has the rest.
std::string certainty(const Recommendation& advice) {
  const study::Verdict verdict = advice.confirmation->verdict;
  const std::size_t runs = advice.confirmation->runs.size();
  const std::string times = fmt::format("{} run{}", runs, runs == 1 ? "" : "s");
  std::string text = verdict == study::Verdict::confirmed
                         ? fmt::format("- simulated again ({}): it held\n", times)
                     : verdict == study::Verdict::refuted
                         ? fmt::format("- **simulated again ({}): it did not hold**\n", times)
                         : "- not simulated again: its scatter is not known\n";
  if (const auto share = advice.recommended->probability_feasible) {
    text +=
        fmt::format("- probability that it meets every constraint, by the surrogate: {:.0f} %\n",
                    100.0 * *share);
  }
  return text;
}

std::string constraints_line(const std::vector<ConstraintResult>& constraints) {
  if (constraints.empty()) return "";
  std::vector<std::string> active;
  for (const ConstraintResult& constraint : constraints) {
    if (constraint.active) active.push_back(constraint_label(constraint));
  }
  const std::string text = constraints.size() == 1
                               ? "- the constraint holds"
                               : fmt::format("- all {} constraints hold", constraints.size());
  return text + (active.empty() ? "; none is close to its limit\n"
                                : fmt::format("; at its limit: {}\n", joined(active)));
}

}  // namespace

std::string opening_section(const Recommendation& advice) {
  if (!advice.recommended) return opening_without_pick(advice);
  const StudyFacts& study = advice.study;
  const DesignReport& best = advice.recommended->design;
  std::string text = fmt::format("# Recommended arrangement: {}\n\n", study.spec.name);
  text += fmt::format("**{}** (design {}).\n\n", design_words(best.design), best.id);
  for (std::size_t j = 0; j < best.objectives.size(); ++j) {
    const ObjectiveResult& objective = best.objectives[j];
    const std::string estimate = estimate_text(advice.recommended->estimates[j].estimate);
    text += fmt::format("- {}: **{}** (to be {}d){}\n", objective_name(objective.terms),
                        objective_words(objective), goal_word(objective.terms.goal),
                        estimate == "-" ? "" : "; surrogate " + estimate);
  }
  text += constraints_line(best.constraints) + certainty(advice);
  text += fmt::format("- {} designs evaluated: {} feasible, {} failed\n\n", study.evaluations,
                      study.feasible, study.failed);
  return text + fmt::format("How it was chosen. {}\n\n", advice.rule.words);
}

}  // namespace parapet::reports
