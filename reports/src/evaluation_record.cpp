#include <stdexcept>

#include "parapet/reports/evaluation_log.hpp"

namespace parapet::reports {
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

}  // namespace

Json to_json(const EvaluationRecord& record) {
  Json json;
  json["id"] = record.id;
  json["stage"] = record.stage;
  json["design"] = record.design;
  json["status"] = record.ok ? "ok" : "failed";
  json["reason"] = record.reason;
  json["metrics"] = Json::object();
  json["metrics_absent"] = Json::object();
  for (const solver::Metric& metric : record.metrics) {
    json["metrics"][metric.key] = optional_json(metric.value);
    if (!metric.value) json["metrics_absent"][metric.key] = metric.absent_reason;
  }
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
  return json;
}

EvaluationRecord record_from_json(const Json& json) {
  EvaluationRecord record;
  record.id = json.at("id").get<std::string>();
  record.stage = json.at("stage").get<std::string>();
  record.design = json.at("design").get<designs::Design>();
  const auto status = json.at("status").get<std::string>();
  if (status != "ok" && status != "failed") {
    throw std::runtime_error("status is \"" + status + "\", neither \"ok\" nor \"failed\"");
  }
  record.ok = status == "ok";
  record.reason = json.at("reason").get<std::string>();
  const Json& absent = json.at("metrics_absent");
  for (const auto& [key, value] : json.at("metrics").items()) {
    record.metrics.push_back({key, optional_number(value), absent.value(key, "")});
  }
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
  return record;
}

}  // namespace parapet::reports
