#include "design_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

/// Whether an objective is a formula without a name of its own.
bool is_bare_formula(const ObjectiveTerms& objective) {
  return !objective.expression.empty() && objective.expression == objective.name;
}

}  // namespace

std::string objective_unit_key(const ObjectiveTerms& objective) {
  if (is_bare_formula(objective)) return "";
  return unit_key(objective);
}

std::string design_words(const WrittenDesign& design) {
  std::vector<std::string> parts;
  for (const WrittenVariable& variable : design) {
    const auto* option = std::get_if<std::string>(&variable.value);
    parts.push_back(fmt::format(
        "{} {}", key_words(variable.name),
        option != nullptr ? *option : with_unit(std::get<double>(variable.value), variable.name)));
  }
  return joined(parts);
}

std::string variable_cell(const WrittenDesign& design, const std::string& name) {
  const auto found = std::ranges::find(design, name, &WrittenVariable::name);
  if (found == design.end()) return "";
  const auto* option = std::get_if<std::string>(&found->value);
  return option != nullptr ? *option : number_text(std::get<double>(found->value));
}

std::string objective_name(const ObjectiveTerms& objective) {
  std::string words =
      is_bare_formula(objective) ? fmt::format("`{}`", objective.name) : key_words(objective.name);
  if (!objective.statistic.empty()) words += ", " + objective.statistic;
  return words;
}

std::string objective_label(const ObjectiveTerms& objective) {
  return objective_name(objective) + bracketed_unit(objective_unit_key(objective));
}

std::string objective_value(const ObjectiveTerms& objective, const std::optional<double>& value) {
  return with_unit(value, objective_unit_key(objective));
}

std::string estimate_text(const study::Estimate& estimate) {
  if (!estimate.median) return "-";
  return fmt::format("{} ({} to {})", number_text(estimate.median), number_text(estimate.lower_95),
                     number_text(estimate.upper_95));
}

std::string constraint_label(const ConstraintResult& constraint) {
  if (constraint.metric.empty()) return constraint.name;
  const std::string label = key_label(constraint.metric);
  return constraint.statistic.empty() ? label : label + ", " + constraint.statistic;
}

}  // namespace parapet::reports
