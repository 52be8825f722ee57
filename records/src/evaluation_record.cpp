#include <stdexcept>

#include "parapet/records/evaluation_log.hpp"

namespace parapet::records {
namespace {

using designs::Json;

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::optional<double> optional_number(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return json.get<double>();
}

Json to_json(const ObjectiveRecord& objective) {
  Json json;
  json["metric"] = objective.metric;
  json["goal"] = objective.goal == designs::Goal::maximize ? "maximize" : "minimize";
  json["weight"] = objective.weight;
  json["value"] = optional_json(objective.value);
  json["absent"] = objective.absent;
  return json;
}

Json to_json(const ConstraintRecord& constraint) {
  Json json;
  json["name"] = constraint.name;
  json["value"] = optional_json(constraint.value);
  json["lower"] = optional_json(constraint.lower);
  json["upper"] = optional_json(constraint.upper);
  json["satisfied"] = constraint.satisfied;
  json["margin"] = optional_json(constraint.margin);
  return json;
}

ObjectiveRecord objective_from_json(const Json& json) {
  ObjectiveRecord objective;
  objective.metric = json.at("metric").get<std::string>();
  objective.goal = json.at("goal").get<std::string>() == "minimize" ? designs::Goal::minimize
                                                                    : designs::Goal::maximize;
  objective.weight = json.at("weight").get<double>();
  objective.value = optional_number(json.at("value"));
  objective.absent = json.at("absent").get<bool>();
  return objective;
}

ConstraintRecord constraint_from_json(const Json& json) {
  ConstraintRecord constraint;
  constraint.name = json.at("name").get<std::string>();
  constraint.value = optional_number(json.at("value"));
  constraint.lower = optional_number(json.at("lower"));
  constraint.upper = optional_number(json.at("upper"));
  constraint.satisfied = json.at("satisfied").get<bool>();
  constraint.margin = optional_number(json.at("margin"));
  return constraint;
}

Json metrics_json(const std::vector<solver::Metric>& metrics) {
  Json json = Json::object();
  for (const solver::Metric& metric : metrics) json[metric.key] = optional_json(metric.value);
  return json;
}

Json absent_json(const std::vector<solver::Metric>& metrics) {
  Json json = Json::object();
  for (const solver::Metric& metric : metrics) {
    if (!metric.value) json[metric.key] = metric.absent_reason;
  }
  return json;
}

std::vector<solver::Metric> metrics_from_json(const Json& json) {
  std::vector<solver::Metric> metrics;
  const Json& absent = json.at("metrics_absent");
  for (const auto& [key, value] : json.at("metrics").items()) {
    metrics.push_back({key, optional_number(value), absent.value(key, "")});
  }
  return metrics;
}

bool ok_from_json(const Json& json) {
  const auto status = json.at("status").get<std::string>();
  if (status != "ok" && status != "failed") {
    throw std::runtime_error("status is \"" + status + "\", neither \"ok\" nor \"failed\"");
  }
  return status == "ok";
}

}  // namespace

Json to_json(const ScenarioRecord& scenario) {
  Json json;
  json["name"] = scenario.name;
  json["weight"] = scenario.weight;
  json["status"] = scenario.ok ? "ok" : "failed";
  json["reason"] = scenario.reason;
  json["metrics"] = metrics_json(scenario.metrics);
  json["metrics_absent"] = absent_json(scenario.metrics);
  json["wall_time_s"] = scenario.wall_time;
  json["cpu_time_s"] = scenario.cpu_time;
  json["particle_steps"] = scenario.particle_steps;
  if (!scenario.stop_reason.empty()) json["stop_reason"] = scenario.stop_reason;
  return json;
}

ScenarioRecord scenario_from_json(const Json& json) {
  ScenarioRecord scenario;
  scenario.name = json.at("name").get<std::string>();
  scenario.weight = json.at("weight").get<double>();
  scenario.ok = ok_from_json(json);
  scenario.reason = json.at("reason").get<std::string>();
  scenario.metrics = metrics_from_json(json);
  scenario.wall_time = json.at("wall_time_s").get<double>();
  scenario.cpu_time = json.value("cpu_time_s", 0.0);
  scenario.particle_steps = json.value("particle_steps", 0.0);
  scenario.stop_reason = json.value("stop_reason", "");
  return scenario;
}

Json to_json(const EvaluationRecord& record) {
  Json json;
  json["id"] = record.id;
  json["stage"] = record.stage;
  json["design"] = record.design;
  if (!record.options.empty()) json["options"] = record.options;
  json["status"] = record.ok ? "ok" : "failed";
  json["reason"] = record.reason;
  json["metrics"] = metrics_json(record.metrics);
  json["metrics_absent"] = absent_json(record.metrics);
  json["objectives"] = Json::array();
  for (const auto& objective : record.objectives) json["objectives"].push_back(to_json(objective));
  json["objective_scalar"] = optional_json(record.objective_scalar);
  json["constraints"] = Json::array();
  for (const auto& constraint : record.constraints) {
    json["constraints"].push_back(to_json(constraint));
  }
  json["feasible"] = record.feasible;
  json["spacing_m"] = record.spacing;
  json["wall_time_s"] = record.wall_time;
  if (record.cpu_time > 0.0) json["cpu_time_s"] = record.cpu_time;
  if (record.particle_steps > 0.0) json["particle_steps"] = record.particle_steps;
  if (!record.stop_reason.empty()) json["stop_reason"] = record.stop_reason;
  if (record.scenarios.empty()) return json;
  json["scenarios"] = Json::array();
  for (const auto& scenario : record.scenarios) json["scenarios"].push_back(to_json(scenario));
  return json;
}

EvaluationRecord record_from_json(const Json& json) {
  EvaluationRecord record;
  record.id = json.at("id").get<std::string>();
  record.stage = json.at("stage").get<std::string>();
  record.design = json.at("design").get<designs::Design>();
  if (json.contains("options")) {
    record.options = json["options"].get<std::map<std::string, std::string>>();
  }
  record.ok = ok_from_json(json);
  record.reason = json.at("reason").get<std::string>();
  record.metrics = metrics_from_json(json);
  for (const Json& item : json.at("objectives")) {
    record.objectives.push_back(objective_from_json(item));
  }
  record.objective_scalar = optional_number(json.at("objective_scalar"));
  for (const Json& item : json.at("constraints")) {
    record.constraints.push_back(constraint_from_json(item));
  }
  record.feasible = json.at("feasible").get<bool>();
  record.spacing = json.at("spacing_m").get<double>();
  record.wall_time = json.at("wall_time_s").get<double>();
  record.cpu_time = json.value("cpu_time_s", 0.0);
  record.particle_steps = json.value("particle_steps", 0.0);
  record.stop_reason = json.value("stop_reason", "");
  if (!json.contains("scenarios")) return record;
  for (const Json& item : json["scenarios"]) record.scenarios.push_back(scenario_from_json(item));
  return record;
}

}  // namespace parapet::records
