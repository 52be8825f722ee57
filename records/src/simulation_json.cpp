#include "parapet/records/simulation_json.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "parapet/records/result_json.hpp"
#include "parapet/records/whole_number.hpp"

namespace parapet::records {
namespace {

using designs::Json;

constexpr const char* format = "parapet-simulation-outcome/1";

/// JSON has no numbers that are not finite.
Json number_json(double value) {
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return "nan";
  return value > 0.0 ? "inf" : "-inf";
}

double number_from_json(const Json& json) {
  if (!json.is_string()) return json.get<double>();
  const auto text = json.get<std::string>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  throw std::runtime_error("\"" + text + "\" is not a number");
}

Json numbers_json(const std::vector<double>& values) {
  Json json = Json::array();
  for (const double value : values) json.push_back(number_json(value));
  return json;
}

std::vector<double> numbers_from_json(const Json& json) {
  std::vector<double> values;
  for (const Json& item : json) values.push_back(number_from_json(item));
  return values;
}

Json uncertainty_json(const solver::MetricUncertainty& uncertainty) {
  Json json;
  json["expanded_95"] = number_json(uncertainty.expanded);
  json["discretisation"] = number_json(uncertainty.discretisation);
  json["scatter"] = number_json(uncertainty.scatter);
  json["extrapolated"] = number_json(uncertainty.extrapolated);
  json["order"] = number_json(uncertainty.order);
  json["order_observed"] = uncertainty.order_observed;
  json["runs"] = uncertainty.runs;
  json["level_spacings_m"] = numbers_json(uncertainty.level_spacing);
  json["level_means"] = numbers_json(uncertainty.level_mean);
  return json;
}

solver::MetricUncertainty uncertainty_from_json(const Json& json) {
  return {.expanded = number_from_json(json.at("expanded_95")),
          .discretisation = number_from_json(json.at("discretisation")),
          .scatter = number_from_json(json.at("scatter")),
          .extrapolated = number_from_json(json.at("extrapolated")),
          .order = number_from_json(json.at("order")),
          .order_observed = json.at("order_observed").get<bool>(),
          .runs = whole_number<int>(json.at("runs")),
          .level_spacing = numbers_from_json(json.at("level_spacings_m")),
          .level_mean = numbers_from_json(json.at("level_means"))};
}

Json metric_json(const solver::Metric& metric) {
  Json json;
  json["key"] = metric.key;
  json["value"] = metric.value ? number_json(*metric.value) : Json(nullptr);
  json["absent_reason"] = metric.absent_reason;
  if (!metric.value) json["absence"] = solver::to_string(metric.absence);
  if (metric.uncertainty) json["uncertainty"] = uncertainty_json(*metric.uncertainty);
  return json;
}

solver::Metric metric_from_json(const Json& json) {
  solver::Metric metric;
  metric.key = json.at("key").get<std::string>();
  if (const Json& value = json.at("value"); !value.is_null()) {
    metric.value = number_from_json(value);
  }
  metric.absent_reason = json.at("absent_reason").get<std::string>();
  if (!metric.value) metric.absence = solver::absence_of(json.value("absence", ""));
  if (json.contains("uncertainty")) {
    metric.uncertainty = uncertainty_from_json(json["uncertainty"]);
  }
  return metric;
}

}  // namespace

Json to_json(const Simulation& simulation) {
  Json json;
  json["format"] = format;
  json["ok"] = simulation.ok;
  json["cancelled"] = simulation.cancelled;
  json["reason"] = simulation.reason;
  json["stop_reason"] = simulation.stop_reason;
  json["metrics"] = Json::array();
  for (const solver::Metric& metric : simulation.metrics) {
    json["metrics"].push_back(metric_json(metric));
  }
  json["wall_time_s"] = number_json(simulation.wall_time);
  json["cpu_time_s"] = number_json(simulation.cpu_time);
  json["particle_steps"] = number_json(simulation.particle_steps);
  if (!simulation.warnings.empty()) json["warnings"] = warnings_json(simulation.warnings);
  json["report"] = simulation.report;
  return json;
}

Simulation simulation_from_json(const Json& json) {
  if (json.at("format") != format) throw std::runtime_error(std::string("not a ") + format);
  Simulation simulation;
  simulation.ok = json.at("ok").get<bool>();
  simulation.cancelled = json.at("cancelled").get<bool>();
  simulation.reason = json.at("reason").get<std::string>();
  simulation.stop_reason = json.at("stop_reason").get<std::string>();
  for (const Json& item : json.at("metrics")) simulation.metrics.push_back(metric_from_json(item));
  simulation.wall_time = number_from_json(json.at("wall_time_s"));
  simulation.cpu_time = number_from_json(json.at("cpu_time_s"));
  simulation.particle_steps = number_from_json(json.at("particle_steps"));
  simulation.warnings = warnings_from_json(json.value("warnings", Json()));
  simulation.report = json.at("report");
  return simulation;
}

}  // namespace parapet::records
