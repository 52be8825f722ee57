#include "parapet/study/sensitivity_file.hpp"

#include <cmath>
#include <limits>

#include "companion_file.hpp"
#include "parapet/records/whole_number.hpp"

namespace parapet::study {
namespace {

using designs::Json;

constexpr const char* format = "parapet-sensitivity/1";

Json to_json(const SobolIndex& index) {
  return {{"value", index.value}, {"lower_95", index.lower_95}, {"upper_95", index.upper_95}};
}

Json to_json(const MainEffect& effect) {
  Json places = Json::array();
  for (const VariablePlace& place : effect.at) {
    places.push_back(std::visit([](const auto& value) { return Json(value); }, place));
  }
  return {{"at", std::move(places)},
          {"mean", effect.mean},
          {"lower_95", effect.lower_95},
          {"upper_95", effect.upper_95}};
}

Json to_json(const MetricSensitivity& metric) {
  Json variables = Json::array();
  for (const VariableSensitivity& variable : metric.variables) {
    variables.push_back({{"name", variable.name},
                         {"first", to_json(variable.first)},
                         {"total", to_json(variable.total)},
                         {"main_effect", to_json(variable.main_effect)}});
  }
  Json json{{"name", metric.name},
            {"metric", metric.metric},
            {"designs", metric.designs},
            {"q_squared", metric.q_squared ? Json(*metric.q_squared) : Json(nullptr)},
            {"varies", metric.varies},
            {"variables", std::move(variables)}};
  if (!metric.statistic.empty()) json["statistic"] = metric.statistic;
  return json;
}

/// What is not finite is null in the file.
double number(const Json& json) {
  return optional_number(json).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::vector<double> numbers(const Json& json) {
  std::vector<double> values;
  for (const Json& one : json) values.push_back(number(one));
  return values;
}

SobolIndex read_index(const Json& json) {
  return {.value = number(json.at("value")),
          .lower_95 = number(json.at("lower_95")),
          .upper_95 = number(json.at("upper_95"))};
}

MainEffect read_effect(const Json& json) {
  MainEffect effect{.at = {},
                    .mean = numbers(json.at("mean")),
                    .lower_95 = numbers(json.at("lower_95")),
                    .upper_95 = numbers(json.at("upper_95"))};
  for (const Json& place : json.at("at")) {
    effect.at.push_back(place.is_string() ? VariablePlace(place.get<std::string>())
                                          : VariablePlace(place.get<double>()));
  }
  return effect;
}

MetricSensitivity read_metric(const Json& json) {
  MetricSensitivity metric;
  metric.name = json.at("name").get<std::string>();
  metric.metric = json.at("metric").get<std::string>();
  metric.statistic = json.value("statistic", "");
  metric.designs = records::whole_number<int>(json.at("designs"));
  metric.q_squared = optional_number(json.at("q_squared"));
  metric.varies = json.at("varies").get<bool>();
  for (const Json& variable : json.at("variables")) {
    metric.variables.push_back({.name = variable.at("name").get<std::string>(),
                                .first = read_index(variable.at("first")),
                                .total = read_index(variable.at("total")),
                                .main_effect = read_effect(variable.at("main_effect"))});
  }
  return metric;
}

}  // namespace

Json to_json(const Sensitivity& sensitivity) {
  Json json{{"format", format},
            {"name", sensitivity.study_name},
            {"spec_hash", sensitivity.spec_hash},
            {"source", sensitivity.source},
            {"domain", sensitivity.domain},
            {"realisations", sensitivity.realisations},
            {"base_points", sensitivity.base_points},
            {"metrics", Json::array()}};
  for (const MetricSensitivity& metric : sensitivity.metrics) {
    json["metrics"].push_back(to_json(metric));
  }
  return json;
}

std::optional<Sensitivity> read_sensitivity(const std::filesystem::path& file,
                                            const std::string& spec_hash) {
  const Json json = read_companion(file, format, spec_hash);
  if (json.is_null()) return std::nullopt;
  try {
    Sensitivity result{.study_name = json.at("name").get<std::string>(),
                       .spec_hash = spec_hash,
                       .source = json.at("source").get<std::string>(),
                       .domain = json.at("domain").get<std::string>(),
                       .realisations = records::whole_number<int>(json.at("realisations")),
                       .base_points = records::whole_number<int>(json.at("base_points")),
                       .metrics = {}};
    for (const Json& metric : json.at("metrics")) result.metrics.push_back(read_metric(metric));
    return result;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace parapet::study
