#include "parapet/records/approach_json.hpp"

#include <string>

#include "parapet/records/result_json.hpp"

namespace parapet::records {
namespace {

using designs::Json;

Json number_or_null_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json metric_json(const solver::Result* result, const std::string& key) {
  const solver::Metric* metric = result == nullptr ? nullptr : result->find_metric(key);
  return metric == nullptr ? Json(nullptr) : number_or_null_json(metric->value);
}

std::optional<double> number_or_absent(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

}  // namespace

Json approach_file_json(const designs::CaseSpec& spec, const solver::UndisturbedRun& open,
                        const solver::Result* with_barriers, const Json& provenance) {
  Json barriers = Json::array();
  for (std::size_t k = 0; k < spec.scene.barriers.size(); ++k) {
    const std::string b = "barrier_" + std::to_string(k + 1) + "_";
    const double foot = spec.scene.barriers[k].foot_x;
    const solver::Approach flow = open.profile.at(foot);
    Json one;
    one["foot_x_m"] = foot;
    one.update(designs::approach_json(flow));
    one["froude_number"] = number_or_null_json(flow.froude_number(spec.scene));
    for (const char* key :
         {"design_force_n_per_m", "hydrodynamic_coefficient", "hydrostatic_coefficient"}) {
      one[key] = metric_json(with_barriers, b + key);
    }
    barriers.push_back(std::move(one));
  }
  Json profile = {{"x_m", open.profile.x},
                  {"front_velocity_m_s", Json::array()},
                  {"flow_depth_max_m", Json::array()}};
  for (const solver::Approach& flow : open.profile.places) {
    const Json one = designs::approach_json(flow);
    for (const auto& [key, value] : one.items()) profile[key].push_back(value);
  }
  // the keys of the first barrier are those of earlier versions
  const Json& first = barriers.front();
  Json json;
  json["format"] = "parapet-approach/1";
  json["name"] = spec.name;
  for (const char* key : {"foot_x_m", "front_velocity_m_s", "flow_depth_max_m", "froude_number"}) {
    json[key] = first.at(key);
  }
  json["barrier_1_design_force_n_per_m"] = first.at("design_force_n_per_m");
  json["alpha"] = first.at("hydrodynamic_coefficient");
  json["k"] = first.at("hydrostatic_coefficient");
  json["barriers"] = std::move(barriers);
  json["profile"] = std::move(profile);
  json["warnings"] = {
      {"undisturbed", warnings_json(open.result.warnings)},
      {"with_barrier",
       with_barriers == nullptr ? Json::array() : warnings_json(with_barriers->warnings)}};
  json["provenance"] = provenance;
  return json;
}

solver::ApproachProfile profile_from_json(const Json& file) {
  const Json& json = file.at("profile");
  solver::ApproachProfile profile;
  profile.x = json.at("x_m").get<std::vector<double>>();
  for (std::size_t k = 0; k < profile.x.size(); ++k) {
    profile.places.push_back({number_or_absent(json.at("front_velocity_m_s").at(k)),
                              number_or_absent(json.at("flow_depth_max_m").at(k))});
  }
  return profile;
}

}  // namespace parapet::records
