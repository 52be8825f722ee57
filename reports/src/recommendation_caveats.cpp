#include "recommendation_caveats.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>

namespace parapet::reports {

using designs::Json;

namespace {

// The JSON in a file of the study folder; null when it is missing or not readable.
Json read_quietly(const std::filesystem::path& path) {
  std::ifstream file(path);
  return file ? Json::parse(file, nullptr, false) : Json();
}

std::string stop_reason(const StudyLog& log, const LoggedDesign& design) {
  const Json report = read_quietly(log.path / "evaluations" / (design.id + ".json"));
  const Json::json_pointer place("/simulation/stop_reason");
  return report.is_object() && report.contains(place) ? report.at(place).get<std::string>() : "";
}

void add_unfinished(Json& list, const StudyLog& log, const LoggedDesign* best) {
  int unsettled = 0, simulated = 0;
  for (const LoggedDesign& design : log.designs) {
    if (!design.ok) continue;
    ++simulated;
    unsettled += stop_reason(log, design) == "end_time" ? 1 : 0;
  }
  if (unsettled > 0) {
    const bool chosen = best != nullptr && stop_reason(log, *best) == "end_time";
    list.push_back(fmt::format(
        "{} of {} simulations{} ended at the stop time while the flow had not settled: retention "
        "and "
        "launch length may not be final. Allow a longer stop_time_s.",
        unsettled, simulated, chosen ? ", that of the recommended design among them," : ""));
  }
  const Json summary = read_quietly(log.path / "summary.json");
  const std::string state = summary.is_object() ? summary.value("state", "") : "";
  if (state == "running" || state == "interrupted") {
    list.push_back(
        fmt::format("The study is not finished (its state is \"{}\"): the same optimize command "
                    "goes on with it.",
                    state));
  }
}

bool uses_loads(const StudyLog& log) {
  for (const char* part : {"objectives", "constraints"}) {
    if (!log.spec.contains(part)) continue;
    for (const Json& entry : log.spec.at(part)) {
      const std::string metric = entry.is_object() ? entry.value("metric", "") : "";
      if (metric.find("_force_") != std::string::npos ||
          metric.find("_moment_") != std::string::npos) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

Json caveats_json(const StudyLog& log, const LoggedDesign* best, const Json& variables) {
  Json list = Json::array();
  add_unfinished(list, log, best);
  std::set<double> spacings;
  for (const LoggedDesign& design : log.designs) {
    if (design.ok && design.spacing) spacings.insert(*design.spacing);
  }
  if (spacings.size() == 1) {
    list.push_back(fmt::format(
        "All designs were simulated at one particle spacing, {:g} mm. Results still change with "
        "refinement, so check the chosen design at a finer spacing before relying on a margin.",
        1000.0 * *spacings.begin()));
  } else if (spacings.size() > 1) {
    list.push_back(fmt::format(
        "Designs were simulated at {} different particle spacings ({:g} to {:g} mm); comparing "
        "them mixes the effect of the design with that of the resolution.",
        spacings.size(), 1000.0 * *spacings.begin(), 1000.0 * *spacings.rbegin()));
  }
  list.push_back(
      "The model is two-dimensional (a slice per metre width): flow around the barrier's "
      "ends, side walls and uneven beds are not in it.");
  list.push_back(
      "The flow is chaotic after the impact. How far a result moves under tiny changes of the "
      "start "
      "has not been measured for this study; close designs in its log show it. The best of many "
      "scattered values is also a little too good on average.");
  if (uses_loads(log)) {
    list.push_back(
        "A force or moment decides here. Peak loads scatter far more than volumes, by tens of per "
        "cent between nearly equal designs at coarse spacings, and have not been validated against "
        "measurements.");
  }
  list.push_back(
      "One debris material and one release volume were simulated; the ranking of designs "
      "can change for others.");
  if (best != nullptr) {
    for (const Json& variable : variables) {
      if (variable["at_bound"].is_null()) continue;
      list.push_back(fmt::format(
          "{} lies at its {} bound: a wider range might give a better design.",
          variable["name"].get<std::string>(), variable["at_bound"].get<std::string>()));
    }
  }
  if (log.incomplete_last_line) {
    list.push_back(
        "The last line of the log is not complete (the study was stopped, or is still "
        "running); it was left out. Running the study again finishes it.");
  }
  return list;
}

}  // namespace parapet::reports
