#include "parapet/reports/recommendation_text.hpp"

#include <fmt/format.h>

#include <map>

#include "confirmation_text.hpp"
#include "design_sections.hpp"
#include "effects_text.hpp"
#include "estimate_words.hpp"
#include "front_text.hpp"
#include "markdown.hpp"
#include "opening_text.hpp"
#include "other_designs_text.hpp"
#include "repeat_text.hpp"
#include "safe_advice.hpp"
#include "sensitivity_text.hpp"
#include "study_text.hpp"

namespace parapet::reports {
namespace {

/// The rule, and the designs that the data cannot tell from its first.
std::string chosen_section(const Recommendation& advice) {
  if (!advice.recommended) return "";
  const RuleFacts& rule = advice.rule;
  std::string text = fmt::format("## How it was chosen\n\n{}", rule.words);
  if (rule.ties.empty()) return text + "\n\n";
  const std::string& recommended = advice.recommended->design.id;
  text += fmt::format(
      " Of {} draws of what the surrogates do not know, the rule takes each tied design in the "
      "share "
      "below; two are tied where the rule prefers either in 5 % of the draws. Of tied designs the "
      "one with the largest margin is taken: the distance of a mean from its limit in standard "
      "uncertainties, of all limits the least, counted up to {:g}.\n\n",
      rule.draws, study::most_margin);
  std::vector<std::vector<std::string>> rows{
      {"design", "share of the draws", "margin", "meets the constraints"}};
  const auto add = [&](const std::string& name, double share, const std::optional<double>& margin,
                       const std::optional<double>& probability) {
    rows.push_back({name, fmt::format("{:.0f} %", 100.0 * share),
                    margin ? fmt::format("{:.1f}", *margin) : "-", probability_words(probability)});
  };
  add(fmt::format("**{}** (recommended)", recommended), rule.share.value_or(0.0),
      advice.recommended->margin, advice.recommended->probability_feasible);
  for (const TiedDesign& one : rule.ties) {
    const bool first = one.id == rule.first_by_rule;
    add(first ? one.id + " (the rule's first)" : one.id, one.share, one.margin,
        one.probability_feasible);
  }
  return text + table(rows, "lrrr");
}

std::string failed_section(const std::vector<FailedDesign>& failed) {
  if (failed.empty()) return "";
  std::map<std::string, std::vector<std::string>> by_reason;
  for (const FailedDesign& design : failed) by_reason[design.reason].push_back(design.id);
  std::string text =
      "## Failed designs\n\nThese were simulated without a usable result and take no "
      "part in the comparison.\n\n";
  for (const auto& [reason, ids] : by_reason) {
    text += fmt::format("- {}: {}\n", joined(ids), reason);
  }
  return text + "\n";
}

std::string provenance_table(const designs::Json& provenance) {
  if (!provenance.is_object()) return "";
  std::string text = "\n| made with | |\n|---|---|\n";
  for (const auto& [key, value] : provenance.items()) {
    if (value.is_structured()) continue;
    const std::string shown = value.is_string() ? value.get<std::string>() : value.dump();
    text += fmt::format("| {} | {} |\n", cell_text(markdown_text(key)),
                        cell_text(markdown_text(shown)));
  }
  return text;
}

std::string closing(const Recommendation& advice) {
  std::string text = "## What this does not tell\n\n";
  for (const std::string& caveat : advice.caveats) text += "- " + caveat + "\n";
  if (!advice.reproduce) return text;
  const Reproduction& reproduce = *advice.reproduce;
  text +=
      fmt::format("\n## How to repeat it\n\n```\n{}\n{}\n{}\n```\n\n{}. Hash of the spec: `{}`.\n",
                  reproduce.optimize, reproduce.recommend, reproduce.evaluate, reproduce.spec,
                  reproduce.spec_hash);
  return text + provenance_table(reproduce.provenance);
}

}  // namespace

std::string recommendation_text(const Recommendation& given) {
  const Recommendation advice = safe_for_markdown(given);
  const DesignReport* shown = advice.shown();
  std::string text = opening_section(advice) + "# Annex\n\n" + chosen_section(advice);
  if (shown != nullptr) text += variables_section(*shown);
  text += repeat_section(advice);
  text += confirmation_section(advice);
  if (shown != nullptr) text += margins_section(*shown);
  text += front_section(advice);
  if (shown != nullptr) {
    text += improvement_section(advice.improvement) + alternatives_section(advice);
    text += sensitivity_section(advice) + effects_section(advice);
    text += hand_formula_section(*shown) + load_formulas_section(*shown) +
            metrics_section(*shown, advice.definitions);
  }
  return text + study_section(advice.study) + failed_section(advice.failed) + closing(advice);
}

}  // namespace parapet::reports
