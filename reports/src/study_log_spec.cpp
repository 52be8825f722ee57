#include "study_log_spec.hpp"

#include <fmt/format.h>

#include "parapet/designs/error.hpp"

namespace parapet::reports {

using designs::InputError;
using designs::InputIssue;
using designs::Json;

std::optional<double> number(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

std::string text(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

const Json& member(const Json& object, const char* key) {
  static const Json nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

namespace {

LoggedVariable read_choice(const std::string& name, const Json& entry) {
  LoggedVariable variable;
  variable.name = name;
  for (const auto& [option, changes] : entry.at("options").items()) {
    variable.options.push_back(option);
  }
  variable.upper = static_cast<double>(variable.options.size()) - 1.0;
  return variable;
}

/// The statistic of an objective or a constraint in words; empty for a study of one event.
std::string statistic_words(const Json& spec, const Json& stated) {
  const Json& scenarios = member(spec, "scenarios");
  const Json& list = scenarios.is_object() ? member(scenarios, "list") : scenarios;
  if (list.size() < 2 || text(stated, "metric").empty()) {
    return text(stated, "statistic") == "probability" ? "whether within limits" : "";
  }
  const std::string statistic = text(stated, "statistic");
  const double quantile = number(stated, "quantile").value_or(0.9);
  if (statistic == "mean") return "mean over the scenarios";
  if (statistic == "worst") return "worst of the scenarios";
  if (statistic == "quantile") {
    return fmt::format("met or bettered in {:g} % of the scenarios", 100.0 * quantile);
  }
  return statistic == "probability" ? "share of the scenarios within limits" : "";
}

}  // namespace

std::vector<LoggedVariable> read_variables(const Json& spec, const std::string& file) {
  std::vector<LoggedVariable> variables;
  for (const auto& [name, entry] : member(spec, "variables").items()) {
    const std::optional<double> lower = entry.is_object() ? number(entry, "lower") : std::nullopt;
    const std::optional<double> upper = entry.is_object() ? number(entry, "upper") : std::nullopt;
    if (entry.is_object() && member(entry, "options").is_object()) {
      variables.push_back(read_choice(name, entry));
    } else if (lower && upper) {
      variables.push_back({name, *lower, *upper, false, {}, false});
      variables.back().integer = text(entry, "type") == "integer";
    } else {
      throw InputError({InputIssue{file, "/spec/variables/" + name, entry.dump(),
                                   "the variable has no bounds", "lower and upper, numbers"}});
    }
    variables.back().conditional = entry.contains("active_when");
  }
  if (variables.empty()) {
    throw InputError({InputIssue{file, "/spec/variables", "", "the study has no variables",
                                 "an object of at least one variable"}});
  }
  return variables;
}

LoggedConstraint read_constraint(const records::ConstraintRecord& record, const Json& spec) {
  LoggedConstraint constraint;
  constraint.name = record.name;
  constraint.value = record.value;
  constraint.lower = record.lower;
  constraint.upper = record.upper;
  constraint.satisfied = record.satisfied;
  for (const Json& stated : member(spec, "constraints")) {
    if (!stated.is_object() || text(stated, "name") != constraint.name) continue;
    constraint.scale = number(stated, "scale");
    constraint.of = text(stated, "metric");
    constraint.on_metric = !constraint.of.empty();
    if (!constraint.on_metric) constraint.of = text(stated, "expression");
    constraint.statistic = statistic_words(spec, stated);
  }
  return constraint;
}

LoggedObjective read_objective(const records::ObjectiveRecord& record, const Json& spec) {
  LoggedObjective objective;
  objective.metric = objective.of = record.metric;
  objective.goal = record.goal == designs::Goal::minimize ? "minimize" : "maximize";
  objective.weight = record.weight;
  objective.value = record.value;
  objective.absent = record.absent;
  for (const Json& stated : member(spec, "objectives")) {
    if (!stated.is_object()) continue;
    const std::string metric = text(stated, "metric"), formula = text(stated, "expression");
    const std::string name = text(stated, "name");
    if ((name.empty() ? metric + formula : name) != record.metric) continue;
    objective.on_metric = !metric.empty();
    objective.of = metric.empty() ? formula : metric;
    objective.statistic = statistic_words(spec, stated);
  }
  return objective;
}

}  // namespace parapet::reports
