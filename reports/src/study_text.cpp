#include <fmt/format.h>

#include "key_text.hpp"
#include "markdown.hpp"
#include "recommendation_parts.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

std::string text_at(const Json& json, const char* key) {
  return json.is_object() && json.contains(key) ? text_of(json[key]) : "";
}

std::optional<double> number_at(const Json& json, const char* key) {
  return json.is_object() && json.contains(key) ? value_of(json[key]) : std::nullopt;
}

std::string variable_words(const Json& variable) {
  const std::string name = text_of(variable["name"]);
  std::string words = key_words(name);
  if (variable.contains("options")) {
    std::vector<std::string> options;
    for (const Json& option : variable["options"]) options.push_back(text_of(option));
    words += ": one of " + joined(options);
  } else {
    words += fmt::format(": {} to {}{}", number_text(value_of(variable["lower"])),
                         with_unit(value_of(variable["upper"]), name),
                         variable["integer"].get<bool>() ? ", whole numbers" : "");
  }
  if (variable["conditional"].get<bool>()) words += " (exists under some options only)";
  return words;
}

std::string constraint_words(const Json& constraint) {
  const std::string metric = text_at(constraint, "metric");
  const std::string name = text_at(constraint, "name");
  std::string words =
      metric.empty() ? fmt::format("`{}`", text_at(constraint, "expression")) : key_words(metric);
  if (!name.empty() && name != metric) words = fmt::format("{}: {}", name, words);
  const auto lower = number_at(constraint, "lower"), upper = number_at(constraint, "upper");
  const auto limit = [&](const std::optional<double>& value) {
    return metric.empty() ? number_text(value) : with_unit(value, metric);
  };
  if (lower) words += " at least " + limit(lower);
  if (upper) words += std::string(lower ? " and" : "") + " at most " + limit(upper);
  return words;
}

/// What a constraint asks of the scenarios.
std::string over_scenarios(const Json& constraint) {
  if (text_at(constraint, "metric").empty()) return "";
  const std::string statistic = text_at(constraint, "statistic");
  const double share = 100.0 * number_at(constraint, "quantile").value_or(0.9);
  if (statistic == "worst") return " in every scenario";
  if (statistic == "mean") return " on average over the scenarios";
  if (statistic == "quantile" || statistic == "probability") {
    return fmt::format(" in at least {:g} % of the scenarios by weight", share);
  }
  return "";
}

std::string scenarios_words(const Json& scenarios) {
  std::vector<std::string> names;
  for (const Json& scenario : scenarios) {
    const auto weight = number_at(scenario, "weight");
    names.push_back(text_at(scenario, "name") + (weight ? fmt::format(" ({:.3g})", *weight) : ""));
  }
  constexpr std::size_t most_named = 12;
  if (names.size() > most_named) {
    const std::size_t more = names.size() - most_named;
    names.resize(most_named);
    names.push_back(fmt::format("{} more", more));
  }
  return fmt::format(
      "- {} scenarios, with their weights: {}. Every design was simulated under "
      "each.\n",
      scenarios.size(), joined(names));
}

std::string numbers_words(const Json& study) {
  std::string text = fmt::format("- {} designs evaluated by {} simulations",
                                 study["evaluations"].get<int>(), study["simulations"].get<int>());
  if (const auto time = value_of(study["cpu_time_s"])) {
    text += *time >= 3600.0 ? fmt::format(", {:.1f} h of processor time", *time / 3600.0)
                            : fmt::format(", {:.0f} s of processor time", *time);
  }
  text += fmt::format(": {} feasible, {} failed\n", study["feasible"].get<int>(),
                      study["failed"].get<int>());
  std::vector<std::string> levels;
  for (const Json& level : study["spacings"]) {
    levels.push_back(fmt::format("{:.4g} mm ({} designs)",
                                 1000.0 * level["spacing_m"].get<double>(),
                                 level["designs"].get<int>()));
  }
  if (!levels.empty()) text += "- particle spacing: " + joined(levels);
  if (levels.size() > 1 && study["counted_spacing_m"].is_number()) {
    text += fmt::format("; only designs at {:.4g} mm are compared, the others taught the surrogate",
                        1000.0 * study["counted_spacing_m"].get<double>());
  }
  return text + (levels.empty() ? "" : "\n");
}

std::string method_words(const Json& method) {
  if (!method.is_object()) return "";
  std::string text = "- method: " + text_at(method, "algorithm");
  if (const auto evaluations = number_at(method, "max_evaluations")) {
    text += fmt::format(", at most {:.0f} designs", *evaluations);
  }
  if (method.contains("seed")) text += ", seed " + method["seed"].dump();
  return text + "\n";
}

}  // namespace

std::string study_section(const Json& json) {
  const Json& study = json["study"];
  std::string text = "## What was studied\n\n";
  for (const Json& variable : study["variables"]) text += "- " + variable_words(variable) + "\n";
  for (const Json& objective : study["objectives"]) {
    text +=
        fmt::format("- to be {}d: {}{}\n", text_of(objective["goal"]), objective_label(objective),
                    objective.contains("expression") && objective["expression"] != objective["name"]
                        ? fmt::format(" = `{}`", text_of(objective["expression"]))
                        : "");
  }
  const bool several = study["scenarios"].size() > 1;
  for (const Json& constraint : study["constraints"]) {
    text += fmt::format("- required: {}{}\n", constraint_words(constraint),
                        several ? over_scenarios(constraint) : "");
  }
  if (several) text += scenarios_words(study["scenarios"]);
  return text + numbers_words(study) + method_words(study["method"]) + "\n";
}

}  // namespace parapet::reports
