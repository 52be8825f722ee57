#include "study_text.hpp"

#include <fmt/format.h>

#include "design_text.hpp"
#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

std::string variable_words(const designs::Variable& variable) {
  std::string words = key_words(variable.name);
  if (variable.kind == designs::VariableKind::choice) {
    std::vector<std::string> options;
    for (const designs::Option& option : variable.options) options.push_back(option.name);
    words += ": one of " + joined(options);
  } else {
    words += fmt::format(": {} to {}{}", number_text(variable.lower),
                         with_unit(variable.upper, variable.name),
                         variable.kind == designs::VariableKind::integer ? ", whole numbers" : "");
  }
  if (variable.active_when) words += " (exists under some options only)";
  return words;
}

std::string objective_line(const ObjectiveTerms& objective) {
  const std::string& formula = objective.expression;
  return fmt::format(
      "- to be {}d: {}{}\n", goal_word(objective.goal), objective_label(objective),
      !formula.empty() && formula != objective.name ? fmt::format(" = `{}`", formula) : "");
}

std::string constraint_words(const designs::Constraint& constraint) {
  const std::string &metric = constraint.metric, &name = constraint.name;
  std::string words =
      metric.empty() ? fmt::format("`{}`", constraint.expression) : key_words(metric);
  if (!name.empty() && name != metric) words = fmt::format("{}: {}", name, words);
  const auto limit = [&](const std::optional<double>& value) {
    return metric.empty() ? number_text(value) : with_unit(value, metric);
  };
  const auto &lower = constraint.lower, &upper = constraint.upper;
  if (lower) words += " at least " + limit(lower);
  if (upper) words += std::string(lower ? " and" : "") + " at most " + limit(upper);
  return words;
}

/// What a constraint asks of the scenarios.
std::string over_scenarios(const designs::Constraint& constraint) {
  if (constraint.is_of_design()) return "";
  if (constraint.statistic == designs::Statistic::worst) return " in every scenario";
  if (constraint.statistic == designs::Statistic::mean) return " on average over the scenarios";
  return fmt::format(" in at least {:g} % of the scenarios by weight", 100.0 * constraint.quantile);
}

std::string scenarios_words(const std::vector<designs::Scenario>& scenarios) {
  std::vector<std::string> names;
  for (const designs::Scenario& scenario : scenarios) {
    names.push_back(scenario.name + fmt::format(" ({:.3g})", scenario.weight));
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

std::string numbers_words(const StudyFacts& study) {
  std::string text =
      fmt::format("- {} evaluations by {} simulations", study.evaluations, study.simulations);
  if (const double time = study.cpu_time; time > 0.0) {
    text += time >= 3600.0 ? fmt::format(", {:.1f} h of processor time", time / 3600.0)
                           : fmt::format(", {:.0f} s of processor time", time);
  }
  text += "\n";
  std::vector<std::string> levels;
  for (const SpacingCount& level : study.spacings) {
    levels.push_back(fmt::format("{} designs at {:.4g} mm ({} meet every constraint, {} failed)",
                                 level.designs, 1000.0 * level.spacing, level.feasible,
                                 level.failed));
  }
  if (!levels.empty()) text += "- particle spacings: " + joined(levels);
  if (levels.size() > 1) {
    text += fmt::format("; only designs at {:.4g} mm are compared; the others inform the surrogate",
                        1000.0 * study.counted_spacing);
  }
  return text + (levels.empty() ? "" : "\n");
}

}  // namespace

std::string study_section(const StudyFacts& study) {
  const designs::StudySpec& spec = study.spec;
  std::string text = "## What was studied\n\n";
  for (const designs::Variable& one : spec.variables) text += "- " + variable_words(one) + "\n";
  for (const ObjectiveTerms& objective : study.objectives) text += objective_line(objective);
  const bool several = spec.scenarios.size() > 1;
  for (const designs::Constraint& constraint : spec.constraints) {
    text += fmt::format("- required: {}{}\n", constraint_words(constraint),
                        several ? over_scenarios(constraint) : "");
  }
  if (several) text += scenarios_words(spec.scenarios);
  text += numbers_words(study);
  return text + fmt::format("- method: {}, at most {} designs, seed {}\n\n", spec.method.algorithm,
                            spec.method.max_evaluations, spec.method.seed);
}

}  // namespace parapet::reports
