#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "key_text.hpp"
#include "markdown.hpp"
#include "recommendation_parts.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

std::string limit_words(const Json& constraint) {
  const std::optional<double> lower = value_of(constraint["lower"]);
  const std::optional<double> upper = value_of(constraint["upper"]);
  if (lower && upper) return fmt::format("{} to {}", number_text(lower), number_text(upper));
  return lower ? "at least " + number_text(lower) : "at most " + number_text(upper);
}

std::string variables_section(const Json& design) {
  std::vector<std::vector<std::string>> rows{{"variable", "value", "range allowed", ""}};
  for (const Json& variable : design["variables"]) {
    const std::string name = text_of(variable["name"]);
    const std::string bound = text_of(variable["at_bound"]);
    if (variable.contains("option")) {
      std::vector<std::string> options;
      for (const Json& option : variable["options"]) options.push_back(text_of(option));
      rows.push_back({key_words(name), text_of(variable["option"]), joined(options), ""});
      continue;
    }
    rows.push_back({key_words(name), with_unit(value_of(variable["value"]), name),
                    fmt::format("{} to {}", number_text(value_of(variable["lower"])),
                                with_unit(value_of(variable["upper"]), name)),
                    bound.empty() ? "" : fmt::format("at its {} bound", bound)});
  }
  return "## The design\n\n" + table(rows, "lrll");
}

std::string constraints_section(const Json& design) {
  if (design["constraints"].empty()) return "";
  std::vector<std::vector<std::string>> rows{
      {"constraint", "value", "limit", "margin", "of the limit", "state"}};
  for (const Json& constraint : design["constraints"]) {
    const bool holds = constraint["satisfied"].get<bool>();
    std::string state = !holds                             ? "**violated**"
                        : constraint["active"].get<bool>() ? "active"
                        : constraint["value"].is_null()    ? "holds (no value)"
                                                           : "holds";
    rows.push_back({constraint_label(constraint), number_text(value_of(constraint["value"])),
                    limit_words(constraint), signed_text(constraint["margin"]),
                    percent_text(constraint["margin_percent"]), state});
  }
  return "## Margins\n\nA margin is the distance to the nearer limit, negative outside it; below 2 "
         "% "
         "of the limit the constraint is called active.\n\n" +
         table(rows, "lrlrrl");
}

std::string metrics_section(const Json& json, const Json& design) {
  std::vector<std::vector<std::string>> rows{{"metric", "value", "meaning"}};
  std::map<std::string, std::vector<std::string>> absent;  // reason -> metrics
  const Json& definitions = json["definitions"];
  for (const auto& [key, value] : design["metrics"].items()) {
    if (value.is_null()) {
      const Json& reasons = design["metrics_absent"];
      absent[reasons.contains(key) ? text_of(reasons[key]) : "no reason given"].push_back(
          key_words(key));
      continue;
    }
    rows.push_back({key_words(key), with_unit(value_of(value), key),
                    definitions.contains(key) ? text_of(definitions[key]) : ""});
  }
  std::string text = "## Everything measured\n\n" + table(rows, "lrl");
  for (const auto& [reason, keys] : absent) {
    text += fmt::format("Without a value ({}): {}.\n\n", reason, joined(keys));
  }
  return text;
}

std::string hand_formula_section(const Json& design) {
  const Json& metrics = design["metrics"];
  const auto simulated =
      metrics.contains("launch_length_m") ? value_of(metrics["launch_length_m"]) : std::nullopt;
  const auto formula = metrics.contains("ballistic_launch_length_m")
                           ? value_of(metrics["ballistic_launch_length_m"])
                           : std::nullopt;
  if (!simulated || !formula) return "";
  const std::string share =
      *simulated != 0.0 ? fmt::format(" ({:+.0f} %)", 100.0 * (*formula / *simulated - 1.0)) : "";
  return fmt::format(
      "## Launch length against the hand formula\n\nThe simulation lands the overflow {} m from "
      "the barrier's foot; the ballistic formula that engineers use (a point mass thrown where the "
      "overflow crosses the barrier's line, with the simulated speed and angle) gives {} m{}.\n\n",
      number_text(simulated), number_text(formula), share);
}

std::string improvement_section(const Json& improvement) {
  if (improvement.is_null()) return "";
  std::string text = "## Against the starting designs\n\n";
  if (improvement["same_design"].get<bool>()) {
    return text +
           "The search found nothing better than the best starting design, which is the one "
           "recommended.\n\n";
  }
  text += fmt::format("The best starting design was {} ({}), {}.\n\n",
                      text_of(improvement["start_id"]), design_words(improvement["start_design"]),
                      improvement["start_feasible"].get<bool>()
                          ? "which meets the constraints"
                          : "which does not meet the constraints; no starting design did");
  std::vector<std::vector<std::string>> rows{
      {"objective", "start", "recommended", "change", "in per cent", ""}};
  for (const Json& objective : improvement["objectives"]) {
    const Json& better = objective["better"];
    rows.push_back({objective_label(objective), number_text(value_of(objective["start"])),
                    number_text(value_of(objective["best"])), signed_text(objective["change"]),
                    percent_text(objective["change_percent"]),
                    better.is_null()     ? ""
                    : better.get<bool>() ? "better"
                                         : "not better"});
  }
  return text + table(rows, "lrrrrl");
}

std::string alternatives_section(const Json& json) {
  if (!json["feasible"].get<bool>() || !json["front"].empty()) return "";  // the front says it
  if (json["alternatives"].empty()) {
    return "## Alternatives\n\nNo other feasible design differs from it by 5 % of a variable's "
           "range.\n\n";
  }
  const Json& best = json["recommended"];
  std::vector<std::string> heading{"design"};
  std::string alignment = "l";
  const Json& variables = json["study"]["variables"];
  for (const Json& one : variables) heading.push_back(key_label(text_of(one["name"])));
  for (const Json& objective : best["objectives"]) heading.push_back(objective_label(objective));
  heading.push_back("smallest margin");
  alignment.append(heading.size() - 1, 'r');
  std::vector<std::vector<std::string>> rows{heading};
  const auto add = [&](const Json& design, const std::string& name) {
    std::vector<std::string> row{name};
    for (const Json& one : variables) {
      const Json value = design["design"].value(text_of(one["name"]), Json());
      row.push_back(value.is_null()     ? ""
                    : value.is_string() ? text_of(value)
                                        : number_text(value_of(value)));
    }
    for (const Json& objective : design["objectives"]) {
      row.push_back(number_text(value_of(objective["value"])));
    }
    Json smallest;
    for (const Json& constraint : design["constraints"]) {
      const Json& margin = constraint["margin_percent"];
      if (margin.is_number() && (smallest.is_null() || margin < smallest)) smallest = margin;
    }
    row.push_back(percent_text(smallest));
    rows.push_back(std::move(row));
  };
  add(best, fmt::format("**{}** (recommended)", text_of(best["id"])));
  std::vector<std::string> ties;
  for (const Json& design : json["alternatives"]) {
    add(design, text_of(design["id"]));
    if (design["within_scatter"].get<bool>()) ties.push_back(text_of(design["id"]));
  }
  const std::string note =
      ties.empty() ? ""
                   : fmt::format(
                         "Within the scatter about the fit (below), the data cannot rank {} "
                         "against the recommended design.\n\n",
                         joined(ties));
  return "## Alternatives\n\nThe best other feasible designs, each at least 5 % of a variable's "
         "range "
         "from the others. The smallest margin is a share of its limit.\n\n" +
         table(rows, alignment) + note;
}

std::string effects_section(const Json& json) {
  if (json["effects"].empty()) return "";
  std::string text =
      "## What each variable does\n\nLeast-squares fits to all designs that were simulated; they "
      "describe the region that was tried, not what lies beyond. ± is one standard "
      "error, the standardised effect counts in standard deviations. Correlations look at one "
      "variable "
      "alone and mislead where variables were changed together.\n\n";
  for (const Json& fit : json["effects"]) {
    text += fmt::format("### {}\n\n", key_label(text_of(fit["metric"])));
    if (fit["r2"].is_number()) {
      text += fmt::format(
          "Model: {}; {} designs, R² {:.2f} ({:.2f} for designs left out of the fit), "
          "scatter about the fit {}: {}.\n\n",
          text_of(fit["model"]), fit["points"].get<int>(), fit["r2"].get<double>(),
          fit["r2_left_out"].get<double>(),
          with_unit(value_of(fit["scatter"]), text_of(fit["metric"])), text_of(fit["verdict"]));
    } else {
      text += fmt::format("{} designs with a value; {}.\n\n", fit["points"].get<int>(),
                          text_of(fit["verdict"]));
    }
    std::vector<std::vector<std::string>> rows{
        {"variable", "effect", "standardised", "correlation"}};
    for (const auto& [name, effect] : fit["variables"].items()) {
      rows.push_back({key_words(name), text_of(effect["says"]),
                      number_text(value_of(effect["standardised_effect"])),
                      number_text(value_of(effect["correlation"]))});
    }
    if (rows.size() > 1) text += table(rows, "llrr");
  }
  return text;
}

std::string failed_section(const Json& failed) {
  if (failed.empty()) return "";
  std::map<std::string, std::vector<std::string>> by_reason;
  for (const Json& design : failed) {
    by_reason[text_of(design["reason"])].push_back(text_of(design["id"]));
  }
  std::string text =
      "## Failed designs\n\nThese were simulated without a usable result and take no "
      "part in the comparison.\n\n";
  for (const auto& [reason, ids] : by_reason)
    text += fmt::format("- {}: {}\n", joined(ids), reason);
  return text + "\n";
}

std::string closing(const Json& json) {
  std::string text = "## What this does not tell\n\n";
  for (const Json& caveat : json["caveats"]) text += "- " + text_of(caveat) + "\n";
  const Json& reproduce = json["reproduce"];
  if (reproduce.is_null()) return text;
  text += fmt::format(
      "\n## How to repeat it\n\n```\n{}\n{}\n{}\n```\n\n{}. Hash of the spec: `{}`.\n",
      text_of(reproduce["optimize"]), text_of(reproduce["recommend"]),
      text_of(reproduce["evaluate"]), text_of(reproduce["spec"]), text_of(reproduce["spec_hash"]));
  if (reproduce["provenance"].is_object()) {
    text += "\n| made with | |\n|---|---|\n";
    for (const auto& [key, value] : reproduce["provenance"].items()) {
      if (value.is_structured()) continue;
      text += fmt::format("| {} | {} |\n", key,
                          cell_text(value.is_string() ? value.get<std::string>() : value.dump()));
    }
  }
  return text;
}

}  // namespace

std::string recommendation_text(const Json& json) {
  std::string text = opening_section(json);
  const Json& design = json["feasible"].get<bool>() ? json["recommended"] : json["least_violating"];
  if (!design.is_null()) text += variables_section(design);
  text += confirmation_section(json);
  if (!design.is_null()) text += constraints_section(design);
  text += front_section(json);
  if (!design.is_null()) {
    text += improvement_section(json["improvement"]) + alternatives_section(json);
    text += sensitivity_section(json) + effects_section(json);
    text += hand_formula_section(design) + metrics_section(json, design);
  }
  return text + study_section(json) + failed_section(json["failed"]) + closing(json);
}

}  // namespace parapet::reports
