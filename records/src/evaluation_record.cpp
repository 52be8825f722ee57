#include <stdexcept>
#include <string_view>

#include "parapet/records/evaluation_log.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/records/whole_number.hpp"

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
  if (constraint.tolerance) json["tolerance"] = *constraint.tolerance;
  return json;
}

ObjectiveRecord objective_from_json(const Json& json) {
  ObjectiveRecord objective;
  objective.metric = designs::with_present_names(json.at("metric").get<std::string>());
  objective.goal = json.at("goal").get<std::string>() == "minimize" ? designs::Goal::minimize
                                                                    : designs::Goal::maximize;
  objective.weight = json.at("weight").get<double>();
  objective.value = optional_number(json.at("value"));
  objective.absent = json.at("absent").get<bool>();
  return objective;
}

ConstraintRecord constraint_from_json(const Json& json) {
  ConstraintRecord constraint;
  constraint.name = designs::with_present_names(json.at("name").get<std::string>());
  constraint.value = optional_number(json.at("value"));
  constraint.lower = optional_number(json.at("lower"));
  constraint.upper = optional_number(json.at("upper"));
  constraint.satisfied = json.at("satisfied").get<bool>();
  constraint.margin = optional_number(json.at("margin"));
  constraint.tolerance = optional_number(json.value("tolerance", Json()));
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
  const Json unknown = json.value("metrics_unknown", Json::object());
  for (const auto& [key, value] : json.at("metrics").items()) {
    solver::Metric metric{.key = designs::with_present_names(key),
                          .value = optional_number(value),
                          .absent_reason = {}};
    if (!metric.value) {
      metric.absent_reason = absent.value(key, "");
      metric.absence = solver::absence_of(unknown.value(key, ""));
    }
    metrics.push_back(std::move(metric));
  }
  return metrics;
}

/// Metrics that a longer or finer run would bring, with the word for it; only where there are any.
void add_unknown(Json& json, const std::vector<solver::Metric>& metrics) {
  if (Json unknown = metrics_unknown_json(metrics); !unknown.empty()) {
    json["metrics_unknown"] = std::move(unknown);
  }
}

/// Optional texts stand there only when they say something.
void add_text(Json& json, const char* key, const std::string& text) {
  if (!text.empty()) json[key] = text;
}

std::string id_from_json(const Json& json) {
  auto id = json.at("id").get<std::string>();
  if (!is_id(id)) throw std::runtime_error("its id is not one");
  return id;
}

bool ok_from_json(const Json& json) {
  const auto status = json.at("status").get<std::string>();
  if (status != "ok" && status != "failed") {
    throw std::runtime_error("status is \"" + status + "\", neither \"ok\" nor \"failed\"");
  }
  return status == "ok";
}

}  // namespace

bool is_id(const std::string& text) {
  constexpr std::string_view allowed =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.";
  return !text.empty() && text.size() <= 100 && !text.starts_with('.') &&
         text.find_first_not_of(allowed) == std::string::npos;
}

Json to_json(const ScenarioRecord& scenario) {
  Json json;
  json["name"] = scenario.name;
  json["weight"] = scenario.weight;
  json["status"] = scenario.ok ? "ok" : "failed";
  json["reason"] = scenario.reason;
  json["metrics"] = metrics_json(scenario.metrics);
  json["metrics_absent"] = absent_json(scenario.metrics);
  add_unknown(json, scenario.metrics);
  json["wall_time_s"] = scenario.wall_time;
  json["cpu_time_s"] = scenario.cpu_time;
  json["particle_steps"] = scenario.particle_steps;
  add_text(json, "stop_reason", scenario.stop_reason);
  add_text(json, "case_hash", scenario.case_hash);
  if (!scenario.warnings.empty()) json["warnings"] = warnings_json(scenario.warnings);
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
  scenario.case_hash = json.value("case_hash", "");
  scenario.warnings = warnings_from_json(json.value("warnings", Json()));
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
  add_unknown(json, record.metrics);
  json["objectives"] = Json::array();
  for (const auto& objective : record.objectives) json["objectives"].push_back(to_json(objective));
  json["objective_scalar"] = optional_json(record.objective_scalar);
  json["constraints"] = Json::array();
  for (const auto& constraint : record.constraints) {
    json["constraints"].push_back(to_json(constraint));
  }
  for (const TermRecord& term : record.terms) json["terms"][term.name] = optional_json(term.value);
  json["feasible"] = record.feasible;
  json["spacing_m"] = record.spacing;
  json["wall_time_s"] = record.wall_time;
  if (record.cpu_time > 0.0) json["cpu_time_s"] = record.cpu_time;
  if (record.particle_steps > 0.0) json["particle_steps"] = record.particle_steps;
  add_text(json, "stop_reason", record.stop_reason);
  add_text(json, "case_hash", record.case_hash);
  add_text(json, "program_version", record.program_version);
  add_text(json, "git_revision", record.git_revision);
  if (record.physics > 0) json["physics"] = record.physics;
  if (!record.warnings.empty()) json["warnings"] = warnings_json(record.warnings);
  if (record.scenarios.empty()) return json;
  json["scenarios"] = Json::array();
  for (const auto& scenario : record.scenarios) json["scenarios"].push_back(to_json(scenario));
  return json;
}

EvaluationRecord record_from_json(const Json& json) {
  EvaluationRecord record;
  record.id = id_from_json(json);
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
  const Json terms = json.value("terms", Json::object());
  for (const auto& [name, value] : terms.items()) {
    record.terms.push_back({name, optional_number(value)});
  }
  record.feasible = json.at("feasible").get<bool>();
  record.spacing = json.at("spacing_m").get<double>();
  record.wall_time = json.at("wall_time_s").get<double>();
  record.cpu_time = json.value("cpu_time_s", 0.0);
  record.particle_steps = json.value("particle_steps", 0.0);
  record.stop_reason = json.value("stop_reason", "");
  record.case_hash = json.value("case_hash", "");
  record.program_version = json.value("program_version", "");
  record.git_revision = json.value("git_revision", "");
  record.physics = whole_number<int>(json.value("physics", Json(0)));
  record.warnings = warnings_from_json(json.value("warnings", Json()));
  if (!json.contains("scenarios")) return record;
  for (const Json& item : json["scenarios"]) record.scenarios.push_back(scenario_from_json(item));
  return record;
}

Json to_json(const RefusedDesign& refused) {
  Json json;
  json["id"] = refused.id;
  json["design"] = refused.design;
  if (!refused.options.empty()) json["options"] = refused.options;
  json["status"] = "refused";
  json["reason"] = refused.reason;
  json["constraints"] = Json::array();
  for (const auto& constraint : refused.constraints) {
    json["constraints"].push_back(to_json(constraint));
  }
  json["feasible"] = false;
  add_text(json, "program_version", refused.program_version);
  add_text(json, "git_revision", refused.git_revision);
  return json;
}

RefusedDesign refused_from_json(const Json& json) {
  RefusedDesign refused;
  refused.id = id_from_json(json);
  refused.design = json.at("design").get<designs::Design>();
  if (json.contains("options")) {
    refused.options = json["options"].get<std::map<std::string, std::string>>();
  }
  refused.reason = json.at("reason").get<std::string>();
  for (const Json& item : json.at("constraints")) {
    refused.constraints.push_back(constraint_from_json(item));
  }
  refused.program_version = json.value("program_version", "");
  refused.git_revision = json.value("git_revision", "");
  return refused;
}

}  // namespace parapet::records
