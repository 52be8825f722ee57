#include <cmath>
#include <set>
#include <utility>

#include "study_parts.hpp"
#include "study_terms.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

std::optional<double> optional_number(const Json& json, const char* key) {
  if (!json.contains(key) || json.at(key).is_null()) return std::nullopt;
  return json.at(key).get<double>();
}

Statistic read_statistic(const Json& json) {
  const std::string word = json.at("statistic").get<std::string>();
  if (word == "mean") return Statistic::mean;
  if (word == "worst") return Statistic::worst;
  return word == "quantile" ? Statistic::quantile : Statistic::probability;
}

std::map<std::string, double> read_values_when_absent(const Json& json) {
  if (!json.contains("values_when_absent")) return {};
  return json.at("values_when_absent").get<std::map<std::string, double>>();
}

/// The size of the limit: violations of limits of different units then compare.
double default_scale(const Constraint& constraint) {
  for (const auto& limit : {constraint.upper, constraint.lower}) {
    if (limit && *limit != 0.0) return std::abs(*limit);
  }
  return 1.0;
}

Objective read_objective(const Json& json) {
  Objective objective;
  objective.metric = json.value("metric", "");
  objective.expression = json.value("expression", "");
  objective.name =
      json.value("name", objective.metric.empty() ? objective.expression : objective.metric);
  objective.goal = json.at("goal") == "minimize" ? Goal::minimize : Goal::maximize;
  objective.weight = json.at("weight").get<double>();
  objective.scale = json.at("scale").get<double>();
  objective.value_when_absent = optional_number(json, "value_when_absent");
  objective.statistic = read_statistic(json);
  objective.quantile = json.at("quantile").get<double>();
  objective.lower = optional_number(json, "lower");
  objective.upper = optional_number(json, "upper");
  objective.reference = optional_number(json, "reference");
  objective.values_when_absent = read_values_when_absent(json);
  return objective;
}

Constraint read_constraint(const Json& json) {
  Constraint constraint;
  constraint.metric = json.value("metric", "");
  constraint.expression = json.value("expression", "");
  constraint.name =
      json.value("name", constraint.metric.empty() ? constraint.expression : constraint.metric);
  constraint.lower = optional_number(json, "lower");
  constraint.upper = optional_number(json, "upper");
  constraint.scale = optional_number(json, "scale").value_or(default_scale(constraint));
  constraint.satisfied_when_absent = json.at("satisfied_when_absent").get<bool>();
  constraint.value_when_absent = optional_number(json, "value_when_absent");
  constraint.statistic = read_statistic(json);
  constraint.quantile = json.at("quantile").get<double>();
  constraint.values_when_absent = read_values_when_absent(json);
  return constraint;
}

/// Objectives and constraints alike: either a metric or an expression, and what that allows.
class GoalCheck {
 public:
  GoalCheck(const Metrics& metrics, const std::vector<Variable>& variables,
            const std::vector<Term>& terms, Findings& findings)
      : metrics_(metrics), symbols_(metrics, variables, terms), findings_(findings) {}

  /// Writes an expression out. False when there is nothing more to say.
  template <typename Goal>
  bool check_subject(Goal& goal, const std::string& pointer, const std::string& verb) {
    if (goal.metric.empty() == goal.expression.empty()) {
      findings_.add(pointer, verb + (goal.metric.empty() ? " nothing" : " two things"),
                    "either a metric or an expression");
      return false;
    }
    if (!goal.metric.empty()) return check_metric(goal, pointer);
    WrittenOut out =
        symbols_.read(goal.expression, goal.values_when_absent,
                      {.goal = pointer, .expression = pointer + "/expression"}, findings_);
    const bool sound = !out.formula.empty();
    goal.formula = std::move(out.formula);
    goal.metrics = std::move(out.metrics);
    goal.values_when_absent = std::move(out.values_when_absent);
    if (sound) check_use(goal, pointer);
    return sound;
  }

  void check_limits(std::optional<double> lower, std::optional<double> upper,
                    const std::string& pointer) {
    if (!lower && !upper) {
      findings_.add(pointer, "has no limit", "lower, upper or both");
    } else if (lower && upper && *lower > *upper) {
      findings_.add(pointer, "its lower limit is above its upper", "lower <= upper");
    }
  }

 private:
  template <typename Goal>
  bool check_metric(const Goal& goal, const std::string& pointer) {
    if (!goal.values_when_absent.empty()) {
      findings_.add(pointer + "/values_when_absent", "has no use without an expression",
                    "value_when_absent: a number");
    }
    return metrics_.has(goal.metric, pointer + "/metric", findings_);
  }

  /// What an expression has no use for.
  template <typename Goal>
  void check_use(const Goal& goal, const std::string& pointer) {
    if (goal.is_of_design() && goal.statistic != Goal{}.statistic) {
      findings_.add(pointer + "/statistic",
                    "has no use: without a metric an expression is the same in every event",
                    "no statistic, or an expression with a metric");
    }
    if (!goal.value_when_absent) return;
    if (goal.is_of_design()) {
      findings_.add(pointer + "/value_when_absent",
                    "has no use: without a metric an expression has a value always",
                    "no such value, or an expression with a metric");
    } else {
      findings_.add(pointer + "/value_when_absent",
                    "has no use: the values belong to the metrics of the expression",
                    "values_when_absent: a number for each of " + joined(goal.metrics));
    }
  }

  const Metrics& metrics_;
  Symbols symbols_;
  Findings& findings_;
};

void check_objective(Objective& objective, const Metrics& metrics, const std::string& pointer,
                     GoalCheck& check, Findings& findings) {
  const bool sound = check.check_subject(objective, pointer, "asks for");
  if (sound && !objective.metric.empty() && metrics.may_not_exist(objective.metric) &&
      !objective.value_when_absent) {
    findings.add(pointer + "/value_when_absent",
                 "is missing, and " + objective.metric + " does not exist in every run",
                 "a number that counts then");
  }
  if (objective.statistic == Statistic::probability) {
    check.check_limits(objective.lower, objective.upper, pointer);
  } else if (objective.lower || objective.upper) {
    findings.add(pointer + (objective.lower ? "/lower" : "/upper"),
                 "has no use without the statistic probability",
                 "the statistic \"probability\", or a constraint");
  }
}

}  // namespace

std::vector<Objective> read_objectives(const Json& json, const Metrics& metrics,
                                       const std::vector<Variable>& variables,
                                       const std::vector<Term>& terms, Findings& findings) {
  GoalCheck check(metrics, variables, terms, findings);
  std::vector<Objective> objectives;
  std::set<std::string> seen;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const std::string pointer = child_pointer("/objectives", k);
    Objective objective = read_objective(json[k]);
    check_objective(objective, metrics, pointer, check, findings);
    if (!seen.insert(objective.name).second && !objective.name.empty()) {
      const bool by_metric = objective.name == objective.metric;
      findings.add(pointer + (by_metric ? "/metric" : "/name"),
                   by_metric ? "is an objective already"
                             : "another objective is called \"" + objective.name + "\" too",
                   "each metric once, or a name of its own in the key name");
    }
    objectives.push_back(std::move(objective));
  }
  return objectives;
}

std::vector<Constraint> read_constraints(const Json& json, const Metrics& metrics,
                                         const std::vector<Variable>& variables,
                                         const std::vector<Term>& terms, Findings& findings) {
  GoalCheck check(metrics, variables, terms, findings);
  std::vector<Constraint> constraints;
  std::set<std::string> seen;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const std::string pointer = child_pointer("/constraints", k);
    Constraint constraint = read_constraint(json[k]);
    if (constraint.metric.empty() == constraint.expression.empty()) {
      check.check_subject(constraint, pointer, "limits");
      continue;
    }
    check.check_subject(constraint, pointer, "limits");
    check.check_limits(constraint.lower, constraint.upper, pointer);
    if (!seen.insert(constraint.name).second) {
      findings.add(pointer, "another constraint is called \"" + constraint.name + "\" too",
                   "a name of its own, in the key name");
    }
    constraints.push_back(std::move(constraint));
  }
  return constraints;
}

}  // namespace parapet::designs
