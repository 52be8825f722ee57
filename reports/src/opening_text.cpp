#include <fmt/format.h>

#include "key_text.hpp"
#include "markdown.hpp"
#include "recommendation_parts.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

std::string objective_words(const Json& objective) {
  const std::string value = objective_value(objective, value_of(objective["value"]));
  return objective["absent"].get<bool>() ? fmt::format("no value, counted as {}", value) : value;
}

std::string opening_without_pick(const Json& json) {
  const Json& study = json["study"];
  std::string text = fmt::format("# No arrangement to recommend: {}\n\n", text_of(study["name"]));
  if (json["rule"]["allows_none"].get<bool>()) {
    return text + fmt::format(
                      "**{} designs meet every constraint, but none of them the rule's limits on "
                      "objectives.** {} The front below shows what can be had.\n\n",
                      study["feasible"].get<int>(), text_of(json["rule"]["words"]));
  }
  text += fmt::format("**None of the {} designs evaluated meets every constraint.** ",
                      study["evaluations"].get<int>());
  const Json& nearest = json["least_violating"];
  if (nearest.is_null()) return text + "No simulation ended well either.\n\n";
  return text + fmt::format(
                    "The one that misses them least is design {}: {}. It is shown below "
                    "to help in changing the spec, not as advice to build it.\n\n",
                    text_of(nearest["id"]), design_words(nearest["design"]));
}

/// One line on how sure the pick is; the section "How sure" has the rest.
std::string certainty(const Json& json) {
  const std::string verdict = text_of(json["confirmation"]["verdict"]);
  const std::size_t runs = json["confirmation"]["runs"].size();
  const std::string times = fmt::format("{} run{}", runs, runs == 1 ? "" : "s");
  std::string text =
      verdict == "confirmed" ? fmt::format("- simulated again ({}): it held\n", times)
      : verdict == "refuted" ? fmt::format("- **simulated again ({}): it did not hold**\n", times)
                             : "- not simulated again: its scatter is not known\n";
  if (const auto share = value_of(json["recommended"]["probability_feasible"])) {
    text +=
        fmt::format("- probability that it meets every constraint, by the surrogate: {:.0f} %\n",
                    100.0 * *share);
  }
  return text;
}

}  // namespace

std::string opening_section(const Json& json) {
  const Json& study = json["study"];
  if (!json["feasible"].get<bool>()) return opening_without_pick(json);
  const Json& best = json["recommended"];
  std::string text = fmt::format("# Recommended arrangement: {}\n\n", text_of(study["name"]));
  text += fmt::format("**{}** (design {}).\n\n", design_words(best["design"]), text_of(best["id"]));
  for (std::size_t j = 0; j < best["objectives"].size(); ++j) {
    const Json& objective = best["objectives"][j];
    const std::string estimate = estimate_text(best["estimates"][j]);
    text += fmt::format("- {}: **{}** (to be {}d){}\n", objective_name(objective),
                        objective_words(objective), text_of(objective["goal"]),
                        estimate == "-" ? "" : "; surrogate " + estimate);
  }
  std::vector<std::string> active;
  for (const Json& constraint : best["constraints"]) {
    if (constraint["active"].get<bool>()) active.push_back(constraint_label(constraint));
  }
  if (!best["constraints"].empty()) {
    text += best["constraints"].size() == 1
                ? "- the constraint holds"
                : fmt::format("- all {} constraints hold", best["constraints"].size());
    text += active.empty() ? "; none is close to its limit\n"
                           : fmt::format("; at its limit: {}\n", joined(active));
  }
  text += certainty(json);
  text += fmt::format("- {} designs evaluated: {} feasible, {} failed\n\n",
                      study["evaluations"].get<int>(), study["feasible"].get<int>(),
                      study["failed"].get<int>());
  return text + fmt::format("How it was chosen. {}\n\n", text_of(json["rule"]["words"]));
}

}  // namespace parapet::reports
