#include "parapet/records/result_json.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace parapet::records {
namespace {

using designs::Json;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json mass_json(const solver::MassBalance& mass) {
  Json json;
  json["released_kg_per_m"] = mass.released;
  json["in_domain_kg_per_m"] = mass.in_domain;
  json["left_domain_kg_per_m"] = mass.left_domain;
  json["particles_released"] = mass.particles_released;
  json["particles_left"] = mass.particles_left;
  return json;
}

Json statistics_json(const solver::RunStatistics& statistics) {
  Json json;
  json["steps"] = statistics.steps;
  json["neighbor_builds"] = statistics.neighbor_builds;
  json["cg_iterations"] = statistics.cg_iterations;
  json["wall_contacts"] = statistics.wall_contacts;
  json["max_particles_inside_walls"] = statistics.max_particles_inside_walls;
  json["mean_time_step_s"] = number_or_null(statistics.mean_time_step);
  json["max_speed_m_s"] = number_or_null(statistics.max_speed);
  json["max_density_error"] = number_or_null(statistics.max_density_error);
  return json;
}

Json profile_json(const solver::Profile& profile) {
  Json stages = Json::array();
  const double whole = profile.seconds();
  for (const solver::StageTime& stage : profile.stages) {
    Json entry;
    entry["stage"] = stage.name;
    entry["seconds"] = stage.seconds;
    entry["share"] = whole > 0.0 ? stage.seconds / whole : 0.0;
    entry["calls"] = stage.calls;
    if (stage.pairs > 0) entry["directed_pairs"] = stage.pairs;
    stages.push_back(std::move(entry));
  }
  Json json;
  json["seconds"] = whole;
  json["stages"] = std::move(stages);
  json["steps_limited_by"] = {{"acoustic", profile.steps_acoustic},
                              {"acceleration", profile.steps_acceleration},
                              {"viscous", profile.steps_viscous}};
  json["step_shortening"] = profile.step_shortening;
  json["fluid_neighbors_mean"] = profile.fluid_neighbors;
  json["wall_neighbors_mean"] = profile.wall_neighbors;
  json["slots_per_pair"] = profile.slots_per_pair;
  json["steps_after_last_change"] = profile.steps_after_last_change;
  json["rest_share"] = profile.rest_share;
  return json;
}

Json timing_json(const solver::Result& result, int threads) {
  Json json = {{"wall_time_s", result.statistics.wall_time}, {"threads", threads}};
  if (result.profile) json["profile"] = profile_json(*result.profile);
  return json;
}

}  // namespace

Json metrics_json(const solver::Result& result) {
  Json json = Json::object();
  for (const solver::Metric& metric : result.metrics) {
    json[metric.key] = metric.value ? number_or_null(*metric.value) : Json(nullptr);
  }
  return json;
}

Json metrics_absent_json(const solver::Result& result) {
  Json json = Json::object();
  for (const solver::Metric& metric : result.metrics) {
    if (!metric.value) json[metric.key] = metric.absent_reason;
  }
  return json;
}

Json metrics_unknown_json(const std::vector<solver::Metric>& metrics) {
  Json json = Json::object();
  for (const solver::Metric& metric : metrics) {
    if (metric.absence == solver::Absence::run_too_short ||
        metric.absence == solver::Absence::too_coarse) {
      json[metric.key] = solver::to_string(metric.absence);
    }
  }
  return json;
}

Json quality_json(const solver::Quality& quality) {
  Json json;
  json["energy_gain_ratio"] = number_or_null(quality.energy_gain_ratio);
  json["density_error_max"] = number_or_null(quality.density_error_max);
  json["density_error_bulk"] = number_or_null(quality.density_error_bulk);
  json["mass_spread"] = number_or_null(quality.mass_spread);
  json["spray_share_max"] = number_or_null(quality.spray_share_max);
  json["wall_contacts_per_particle"] = number_or_null(quality.wall_contacts_per_particle);
  json["particles_across_approach"] = quality.particles_across_approach
                                          ? number_or_null(*quality.particles_across_approach)
                                          : Json(nullptr);
  return json;
}

Json warnings_json(const std::vector<solver::Warning>& warnings) {
  Json json = Json::array();
  for (const solver::Warning& warning : warnings) {
    json.push_back({{"key", warning.key},
                    {"value", number_or_null(warning.value)},
                    {"limit", number_or_null(warning.limit)},
                    {"text", warning.text}});
  }
  return json;
}

std::vector<solver::Warning> warnings_from_json(const Json& json) {
  const auto number = [](const Json& value) { return value.is_null() ? 0.0 : value.get<double>(); };
  std::vector<solver::Warning> warnings;
  if (json.is_null()) return warnings;
  for (const Json& item : json) {
    warnings.push_back({item.at("key").get<std::string>(), number(item.at("value")),
                        number(item.at("limit")), item.at("text").get<std::string>()});
  }
  return warnings;
}

Json uncertainty_json(const solver::Result& result) {
  Json json = Json::object();
  for (const solver::Metric& metric : result.metrics) {
    if (!metric.uncertainty) continue;
    const solver::MetricUncertainty& u = *metric.uncertainty;
    Json entry;
    entry["expanded_95"] = number_or_null(u.expanded);
    entry["discretisation"] = number_or_null(u.discretisation);
    entry["scatter_standard_deviation"] = number_or_null(u.scatter);
    entry["extrapolated"] = number_or_null(u.extrapolated);
    entry["order"] = number_or_null(u.order);
    entry["order_observed"] = u.order_observed;
    entry["runs"] = u.runs;
    entry["level_spacing_m"] = u.level_spacing;
    entry["level_mean"] = u.level_mean;
    json[metric.key] = std::move(entry);
  }
  return json;
}

Json series_json(const solver::Series& series) {
  Json rows = Json::array();
  for (const auto& row : series.rows) {
    Json values = Json::array();
    for (const double value : row) values.push_back(number_or_null(value));
    rows.push_back(std::move(values));
  }
  Json json;
  json["columns"] = series.columns;
  json["rows"] = std::move(rows);
  return json;
}

std::string series_csv(const solver::Series& series) {
  std::string text;
  for (std::size_t c = 0; c < series.columns.size(); ++c) {
    if (c > 0) text += ',';
    text += series.columns[c];
  }
  text += '\n';
  for (const auto& row : series.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c > 0) text += ',';
      if (std::isfinite(row[c])) text += shortest_number(row[c]);
    }
    text += '\n';
  }
  return text;
}

Json load_profiles_json(const solver::Result& result) {
  Json json = Json::array();
  for (const solver::LoadProfile& profile : result.loads) {
    Json one;
    one["barrier"] = profile.barrier;
    one["part"] = profile.deflector ? "deflector" : "stem";
    one["window_end_s"] = profile.window_end < 0.0 ? Json(nullptr) : Json(profile.window_end);
    one["window_s"] = number_or_null(profile.window);
    one["normal_force_n_per_m"] = number_or_null(profile.normal_force());
    one["edge_m"] = profile.edge;
    one["pressure_pa"] = Json::array();
    for (const double pressure : profile.pressure) {
      one["pressure_pa"].push_back(number_or_null(pressure));
    }
    json.push_back(std::move(one));
  }
  return json;
}

std::string load_profiles_csv(const solver::Result& result) {
  std::string text = "barrier,part,from_m,to_m,pressure_pa\n";
  for (const solver::LoadProfile& profile : result.loads) {
    const std::string part =
        std::to_string(profile.barrier) + (profile.deflector ? ",deflector," : ",stem,");
    for (std::size_t k = 0; k < profile.pressure.size(); ++k) {
      text += part + shortest_number(profile.edge[k]) + ',' + shortest_number(profile.edge[k + 1]) +
              ',';
      if (std::isfinite(profile.pressure[k])) text += shortest_number(profile.pressure[k]);
      text += '\n';
    }
  }
  return text;
}

Json result_json(const std::string& name, const solver::Result& result, const Json& resolved,
                 const Json& provenance, int threads) {
  Json json;
  json["format"] = "parapet-result/1";
  json["name"] = name;
  json["status"] = solver::to_string(result.status);
  json["reason"] = result.reason;
  json["stop_reason"] = solver::to_string(result.stop_reason);
  json["stop_time_s"] = number_or_null(result.stop_time);
  json["metrics"] = metrics_json(result);
  json["metrics_absent"] = metrics_absent_json(result);
  if (Json unknown = metrics_unknown_json(result.metrics); !unknown.empty()) {
    json["metrics_unknown"] = std::move(unknown);
  }
  if (Json uncertainty = uncertainty_json(result); !uncertainty.empty()) {
    json["uncertainty"] = std::move(uncertainty);
  }
  if (!result.loads.empty()) json["loads"] = load_profiles_json(result);
  json["quality"] = quality_json(result.quality);
  json["warnings"] = warnings_json(result.warnings);
  json["mass"] = mass_json(result.mass);
  json["statistics"] = statistics_json(result.statistics);
  json["provenance"] = provenance;
  json["timing"] = timing_json(result, threads);
  json["case"] = resolved;
  return json;
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string shortest_number(double value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return std::string(digits.data(), end);
}

}  // namespace parapet::records
