#include "parapet/reports/recommendation_text.hpp"

#include <fmt/format.h>

#include <map>

#include "confirmation_text.hpp"
#include "design_sections.hpp"
#include "effects_text.hpp"
#include "front_text.hpp"
#include "markdown.hpp"
#include "opening_text.hpp"
#include "other_designs_text.hpp"
#include "safe_advice.hpp"
#include "sensitivity_text.hpp"
#include "study_text.hpp"

namespace parapet::reports {
namespace {

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
  std::string text = opening_section(advice);
  if (shown != nullptr) text += variables_section(*shown);
  text += confirmation_section(advice);
  if (shown != nullptr) text += margins_section(*shown);
  text += front_section(advice);
  if (shown != nullptr) {
    text += improvement_section(advice.improvement) + alternatives_section(advice);
    text += sensitivity_section(advice.sensitivity) + effects_section(advice.effects);
    text += hand_formula_section(*shown) + metrics_section(*shown, advice.definitions);
  }
  return text + study_section(advice.study) + failed_section(advice.failed) + closing(advice);
}

}  // namespace parapet::reports
