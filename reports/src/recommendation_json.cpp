#include "recommendation_json.hpp"

#include <algorithm>
#include <cmath>

#include "markdown.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

constexpr double active_share = 0.02;    // a margin below this share of the limit is "active"
constexpr double at_bound_share = 0.01;  // of a variable's range

Json constraint_json(const LoggedConstraint& constraint) {
  const std::optional<double> margin = constraint.margin();
  const std::optional<double> limit = constraint.nearer_limit();
  const double size = limit && *limit != 0.0 ? std::abs(*limit) : 1.0;
  Json json{{"name", constraint.name}};
  if (!constraint.of.empty()) json[constraint.on_metric ? "metric" : "expression"] = constraint.of;
  if (!constraint.statistic.empty()) json["statistic"] = constraint.statistic;
  json["value"] = optional_json(constraint.value);
  json["lower"] = optional_json(constraint.lower);
  json["upper"] = optional_json(constraint.upper);
  json["satisfied"] = constraint.satisfied;
  json["margin"] = optional_json(margin);
  json["margin_percent"] = percent_json(margin, limit);
  json["active"] = constraint.satisfied && margin && *margin <= active_share * size;
  return json;
}

/// Name, metric, goal and statistic: what an objective is, whatever its value. A formula's unit is
/// that of its name.
Json objective_words(const LoggedObjective& objective) {
  Json json{{"name", objective.metric},
            {"metric", objective.on_metric ? objective.of : objective.metric},
            {"goal", objective.goal}};
  if (!objective.on_metric) json["expression"] = objective.of;
  if (!objective.statistic.empty()) json["statistic"] = objective.statistic;
  return json;
}

Json objectives_json(const LoggedDesign& design) {
  Json list = Json::array();
  for (const LoggedObjective& objective : design.objectives) {
    Json one = objective_words(objective);
    one["weight"] = objective.weight;
    one["value"] = optional_json(objective.value);
    // With scenarios the metric may be missing in some of them only: then its mean has a value.
    one["absent"] = objective.absent && !design.metric(objective.of);
    list.push_back(std::move(one));
  }
  return list;
}

std::string option_of(const LoggedVariable& variable, double value) {
  const auto place = static_cast<std::size_t>(std::max(0.0, std::round(value)));
  return place < variable.options.size() ? variable.options[place] : "?";
}

Json spacings_json(const StudyLog& log) {
  std::map<double, int> counts;
  for (const LoggedDesign& design : log.designs) {
    if (design.spacing) ++counts[*design.spacing];
  }
  Json list = Json::array();
  for (const auto& [spacing, count] : counts) {
    list.push_back({{"spacing_m", spacing}, {"designs", count}});
  }
  return list;
}

Json scenario_list(const StudyLog& log) {
  if (!log.spec.contains("scenarios")) return Json::array();
  const Json& scenarios = log.spec["scenarios"];
  if (scenarios.is_array()) return scenarios;
  return scenarios.is_object() && scenarios.contains("list") ? scenarios["list"] : Json::array();
}

std::size_t simulation_count(const StudyLog& log) {
  std::size_t count = 0;
  for (const LoggedDesign& design : log.designs) {
    count += std::max<std::size_t>(1, design.scenarios.size());
  }
  return count;
}

}  // namespace

Json optional_json(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json percent_json(const std::optional<double>& part, const std::optional<double>& whole) {
  if (!part || !whole || *whole == 0.0) return nullptr;
  return 100.0 * *part / std::abs(*whole);
}

Json written_design(const StudyLog& log, const LoggedDesign& design) {
  Json json = Json::object();
  for (const LoggedVariable& variable : log.variables) {
    const auto found = design.design.find(variable.name);
    if (found == design.design.end()) continue;
    json[variable.name] =
        variable.choice() ? Json(option_of(variable, found->second)) : Json(found->second);
  }
  return json;
}

Json variables_json(const StudyLog& log, const LoggedDesign& design) {
  Json list = Json::array();
  for (const LoggedVariable& variable : log.variables) {
    const auto found = design.design.find(variable.name);
    if (found == design.design.end()) continue;
    const double value = found->second;
    if (variable.choice()) {
      list.push_back({{"name", variable.name},
                      {"option", option_of(variable, value)},
                      {"options", variable.options},
                      {"at_bound", nullptr}});
      continue;
    }
    const double near = at_bound_share * (variable.upper - variable.lower);
    const char* bound = value - variable.lower <= near   ? "lower"
                        : variable.upper - value <= near ? "upper"
                                                         : nullptr;
    list.push_back({{"name", variable.name},
                    {"value", value},
                    {"lower", variable.lower},
                    {"upper", variable.upper},
                    {"at_bound", bound != nullptr ? Json(bound) : Json(nullptr)}});
  }
  return list;
}

Json design_json(const StudyLog& log, const LoggedDesign& design) {
  Json json{{"id", design.id}, {"stage", design.stage}};
  json["design"] = written_design(log, design);
  json["variables"] = variables_json(log, design);
  json["spacing_m"] = optional_json(design.spacing);
  if (!design.scenarios.empty()) json["scenarios"] = design.scenarios;
  json["objective_scalar"] = optional_json(design.objective_scalar);
  json["objectives"] = objectives_json(design);
  json["constraints"] = Json::array();
  for (const LoggedConstraint& constraint : design.constraints) {
    json["constraints"].push_back(constraint_json(constraint));
  }
  json["metrics"] = Json::object();
  json["metrics_absent"] = Json::object();
  for (const solver::Metric& metric : design.metrics) {
    json["metrics"][metric.key] = optional_json(metric.value);
    if (!metric.value) json["metrics_absent"][metric.key] = metric.absent_reason;
  }
  return json;
}

Json estimates_json(const Candidate& candidate) {
  Json list = Json::array();
  for (std::size_t j = 0; j < candidate.design->objectives.size(); ++j) {
    const LoggedObjective& objective = candidate.design->objectives[j];
    Json one = objective_words(objective);
    one["value"] = optional_json(objective.value);
    for (const char* key : {"estimate", "lower_95", "upper_95"}) {
      const Json::json_pointer place = Json::json_pointer("/objectives") / j / key;
      // A formula is known exactly: there is nothing to estimate.
      one[key] = objective.on_metric && candidate.view.contains(place) ? candidate.view.at(place)
                                                                       : Json(nullptr);
    }
    list.push_back(std::move(one));
  }
  return list;
}

Json study_json(const StudyLog& log) {
  int ok = 0, feasible = 0;
  double cpu_time = 0.0;
  for (const LoggedDesign& design : log.designs) {
    ok += design.ok ? 1 : 0;
    feasible += design.feasible ? 1 : 0;
    cpu_time += design.cpu_time;
  }
  const auto name = log.spec.find("name");
  Json json{{"name", name != log.spec.end() && name->is_string() ? *name : Json("study")},
            {"folder", log.folder},
            {"evaluations", log.designs.size()},
            {"ok", ok},
            {"failed", static_cast<int>(log.designs.size()) - ok},
            {"feasible", feasible},
            {"simulations", simulation_count(log)},
            {"cpu_time_s", cpu_time > 0.0 ? Json(cpu_time) : Json(nullptr)},
            {"log_complete", !log.incomplete_last_line},
            {"counted_spacing_m", optional_json(log.counted_spacing())},
            {"spacings", spacings_json(log)}};
  json["variables"] = Json::array();
  for (const LoggedVariable& variable : log.variables) {
    Json one{{"name", variable.name}, {"conditional", variable.conditional}};
    if (variable.choice()) {
      one["options"] = variable.options;
    } else {
      one["lower"] = variable.lower;
      one["upper"] = variable.upper;
      one["integer"] = variable.integer;
    }
    json["variables"].push_back(std::move(one));
  }
  json["objectives"] = Json::array();
  for (const LoggedDesign& design : log.designs) {
    if (design.objectives.empty()) continue;
    for (const LoggedObjective& one : design.objectives) {
      json["objectives"].push_back(objective_words(one));
    }
    break;
  }
  json["constraints"] = log.spec.value("constraints", Json::array());
  json["scenarios"] = scenario_list(log);
  json["method"] = log.spec.value("method", Json());
  return json;
}

}  // namespace parapet::reports
