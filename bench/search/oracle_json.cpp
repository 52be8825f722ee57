#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "oracle.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Eigen::VectorXd& values, int digits) {
  Json list = Json::array();
  for (const double value : values) list.push_back(rounded(value, digits));
  return list;
}

Eigen::VectorXd vector_of(const Json& list) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = list[static_cast<std::size_t>(i)];
  return values;
}

Json surface_json(const RadialSurface& surface) {
  return {{"scale", numbers(surface.scale, 7)},
          {"tail", numbers(surface.tail, weight_digits)},
          {"weights", numbers(surface.weights, weight_digits)}};
}

RadialSurface surface_of(const Json& json) {
  return {vector_of(json.at("scale")), vector_of(json.at("weights")), vector_of(json.at("tail"))};
}

Json metric_json(const MetricSurface& m) {
  Json json = {{"least", m.least}};
  if (m.greatest < std::numeric_limits<double>::infinity()) json["greatest"] = m.greatest;
  json["ridge"] = rounded(m.fit.ridge, 4);
  json["leave_one_out_rms"] = rounded(m.fit.leave_one_out_rms, 4);
  json["q_squared"] = rounded(m.fit.q_squared, 5);
  json["noise"] = rounded(m.fit.noise, 4);
  json["surface"] = surface_json(m.fit.surface);
  if (m.presence) {
    json["presence"] = surface_json(*m.presence);
    json["presence_errors"] = rounded(m.presence_errors, 4);
  }
  return json;
}

MetricSurface metric_of(const Json& json) {
  MetricSurface m;
  m.least = json.at("least");
  m.greatest = json.value("greatest", std::numeric_limits<double>::infinity());
  m.fit.ridge = json.at("ridge");
  m.fit.leave_one_out_rms = json.at("leave_one_out_rms");
  m.fit.q_squared = json.at("q_squared");
  m.fit.noise = json.at("noise");
  m.fit.surface = surface_of(json.at("surface"));
  if (json.contains("presence")) {
    m.presence = surface_of(json.at("presence"));
    m.presence_errors = json.at("presence_errors");
  }
  return m;
}

}  // namespace

double rounded(double value, int digits) {
  return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

Json to_json(const Oracle& oracle) {
  Json json = {{"format", "parapet-search-table/1"},
               {"name", oracle.name},
               {"variables", oracle.variables},
               {"lower", oracle.lower},
               {"upper", oracle.upper},
               {"simulations", static_cast<std::size_t>(oracle.designs.rows())},
               {"median_cpu_time_s", rounded(oracle.median_cpu_time, 4)}};
  json["metrics"] = Json::object();
  for (const auto& [name, metric] : oracle.metrics) json["metrics"][name] = metric_json(metric);
  json["designs"] = Json::array();
  for (Eigen::Index i = 0; i < oracle.designs.rows(); ++i) {
    json["designs"].push_back(numbers(oracle.designs.row(i).transpose(), design_digits));
  }
  json["failed"] = oracle.failed;
  return json;
}

Oracle oracle_from_json(const Json& json) {
  if (json.value("format", "") != "parapet-search-table/1") {
    throw std::invalid_argument("not a table: its format is not parapet-search-table/1");
  }
  Oracle oracle;
  oracle.name = json.at("name");
  oracle.variables = json.at("variables").get<std::vector<std::string>>();
  oracle.lower = json.at("lower").get<std::vector<double>>();
  oracle.upper = json.at("upper").get<std::vector<double>>();
  oracle.median_cpu_time = json.at("median_cpu_time_s");
  for (const auto& [name, metric] : json.at("metrics").items()) {
    oracle.metrics.emplace(name, metric_of(metric));
  }
  const Json& designs = json.at("designs");
  oracle.designs.resize(static_cast<Eigen::Index>(designs.size()),
                        static_cast<Eigen::Index>(oracle.variables.size()));
  for (std::size_t i = 0; i < designs.size(); ++i) {
    oracle.designs.row(static_cast<Eigen::Index>(i)) = vector_of(designs[i]).transpose();
  }
  oracle.failed = json.at("failed").get<std::vector<std::vector<double>>>();
  return oracle;
}

Oracle read_oracle(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::invalid_argument("cannot read " + file.string());
  return oracle_from_json(Json::parse(in));
}

}  // namespace parapet::bench::search
