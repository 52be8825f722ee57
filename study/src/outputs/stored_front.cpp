#include "parapet/study/stored_front.hpp"

#include <algorithm>
#include <limits>

#include "companion_file.hpp"
#include "parapet/records/whole_number.hpp"

namespace parapet::study {
namespace {

using designs::Json;

DesignEstimates read_design(const Json& json) {
  DesignEstimates result;
  result.id = json.at("id").get<std::string>();
  result.probability_feasible = optional_number(json.at("probability_feasible"));
  for (const Json& objective : json.at("objectives")) {
    result.objectives.push_back({.median = optional_number(objective.at("estimate")),
                                 .lower_95 = optional_number(objective.at("lower_95")),
                                 .upper_95 = optional_number(objective.at("upper_95"))});
  }
  return result;
}

FrontEntry read_entry(const Json& json) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {.evaluations = records::whole_number<int>(json.at("evaluations")),
          .cpu_time = optional_number(json.at("cpu_time_s")).value_or(none),
          .hypervolume = optional_number(json.at("hypervolume")).value_or(none)};
}

EventBasis read_events(const Json& json) {
  EventBasis basis{.simulated = records::whole_number<int>(json.at("simulated")),
                   .drawn = records::whole_number<int>(json.at("drawn")),
                   .designs = records::whole_number<int>(json.at("designs")),
                   .errors = {}};
  for (const Json& one : json.at("leave_one_event_out")) {
    basis.errors.push_back({.metric = one.at("metric").get<std::string>(),
                            .rmse = optional_number(one.at("rmse")),
                            .q_squared = optional_number(one.at("q_squared")),
                            .coverage_95 = optional_number(one.at("coverage_95"))});
  }
  return basis;
}

}  // namespace

const DesignEstimates* StoredFront::find(const std::string& id) const {
  const auto found = std::ranges::find(designs, id, &DesignEstimates::id);
  return found == designs.end() ? nullptr : &*found;
}

std::optional<StoredFront> read_stored_front(const std::filesystem::path& file,
                                             const std::string& spec_hash) {
  const Json json = read_companion(file, "parapet-pareto/1", spec_hash);
  if (json.is_null()) return std::nullopt;
  try {
    StoredFront front;
    front.hypervolume = optional_number(json.at("hypervolume"));
    for (const Json& objective : json.at("objectives")) {
      front.reference.push_back(optional_number(objective.at("reference")));
    }
    for (const Json& entry : json.at("history")) front.history.push_back(read_entry(entry));
    if (json.contains("events")) front.events = read_events(json["events"]);
    for (const Json& design : json.at("designs")) front.designs.push_back(read_design(design));
    return front;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace parapet::study
