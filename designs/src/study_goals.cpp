#include <cmath>
#include <set>

#include "study_parts.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

/// The metrics that a scene with this many barriers has.
class Metrics {
 public:
  explicit Metrics(int n_barriers) : catalog_(solver::metric_catalog(n_barriers)) {
    for (const solver::MetricInfo& info : catalog_) keys_.push_back(info.key);
  }

  /// nullptr when there is no such metric; that is then added to the findings.
  const solver::MetricInfo* find(const std::string& key, const std::string& pointer,
                                 Findings& findings) const {
    for (const solver::MetricInfo& info : catalog_) {
      if (info.key == key) return &info;
    }
    findings.add(pointer, "is not a metric of this case" + did_you_mean(key, keys_),
                 "one of " + joined(keys_));
    return nullptr;
  }

 private:
  std::vector<solver::MetricInfo> catalog_;
  std::vector<std::string> keys_;
};

std::optional<double> optional_number(const Json& json, const char* key) {
  if (!json.contains(key) || json.at(key).is_null()) return std::nullopt;
  return json.at(key).get<double>();
}

/// The size of the limit: violations of limits of different units then compare.
double default_scale(const Constraint& constraint) {
  for (const auto& limit : {constraint.upper, constraint.lower}) {
    if (limit && *limit != 0.0) return std::abs(*limit);
  }
  return 1.0;
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
  return constraint;
}

void check_limits(const Constraint& constraint, const std::string& pointer, Findings& findings) {
  if (!constraint.lower && !constraint.upper) {
    findings.add(pointer, "has no limit", "lower, upper or both");
  } else if (constraint.lower && constraint.upper && *constraint.lower > *constraint.upper) {
    findings.add(pointer, "its lower limit is above its upper", "lower <= upper");
  }
}

}  // namespace

std::vector<Objective> read_objectives(const Json& json, int n_barriers, Findings& findings) {
  const Metrics metrics(n_barriers);
  std::vector<Objective> objectives;
  std::set<std::string> seen;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const std::string pointer = child_pointer("/objectives", k);
    Objective objective;
    objective.metric = json[k].at("metric").get<std::string>();
    objective.goal = json[k].at("goal") == "minimize" ? Goal::minimize : Goal::maximize;
    objective.weight = json[k].at("weight").get<double>();
    objective.scale = json[k].at("scale").get<double>();
    objective.value_when_absent = optional_number(json[k], "value_when_absent");
    const solver::MetricInfo* info = metrics.find(objective.metric, pointer + "/metric", findings);
    if (info != nullptr && info->may_be_absent && !objective.value_when_absent) {
      findings.add(pointer + "/value_when_absent",
                   "is missing, and " + objective.metric + " does not exist in every run",
                   "a number that counts then");
    }
    if (!seen.insert(objective.metric).second) {
      findings.add(pointer + "/metric", "is an objective already", "each metric once");
    }
    objectives.push_back(std::move(objective));
  }
  return objectives;
}

std::vector<Constraint> read_constraints(const Json& json, int n_barriers,
                                         const std::vector<Variable>& variables,
                                         Findings& findings) {
  const Metrics metrics(n_barriers);
  std::vector<std::string> names;
  for (const Variable& variable : variables) names.push_back(variable.name);
  std::vector<Constraint> constraints;
  std::set<std::string> seen;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const std::string pointer = child_pointer("/constraints", k);
    const Constraint constraint = read_constraint(json[k]);
    if (constraint.metric.empty() == constraint.expression.empty()) {
      findings.add(pointer, constraint.metric.empty() ? "limits nothing" : "limits two things",
                   "either a metric or an expression");
      continue;
    }
    if (!constraint.metric.empty()) {
      metrics.find(constraint.metric, pointer + "/metric", findings);
    } else {
      const auto [problem, allowed] = expression_problem(constraint.expression, names);
      if (!problem.empty()) findings.add(pointer + "/expression", problem, allowed);
    }
    check_limits(constraint, pointer, findings);
    if (!seen.insert(constraint.name).second) {
      findings.add(pointer, "another constraint is called \"" + constraint.name + "\" too",
                   "a name of its own, in the key name");
    }
    constraints.push_back(constraint);
  }
  return constraints;
}

}  // namespace parapet::designs
