#include "recommendation_caveats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "parapet/study/confirmation.hpp"

namespace parapet::reports {

using designs::Json;

namespace {

// The JSON in a file of the study folder; null when it is missing or not readable.
Json read_quietly(const std::filesystem::path& path) {
  std::ifstream file(path);
  return file ? Json::parse(file, nullptr, false) : Json();
}

/// Designs with a simulation that ended at the stop time: the base event's stands in
/// evaluations/ID.json, a scenario's in evaluations/ID-SCENARIO.json.
std::set<std::string> unsettled_designs(const StudyLog& log) {
  std::set<std::string> ids;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(log.path / "evaluations", none)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".json") continue;
    const Json report = read_quietly(entry.path());
    for (const char* place : {"/simulation/stop_reason", "/details/simulation/stop_reason"}) {
      const Json::json_pointer pointer(place);
      if (report.is_object() && report.contains(pointer) && report.at(pointer) == "end_time") {
        ids.insert(name.substr(0, name.find('-')));
      }
    }
  }
  return ids;
}

void add_unfinished(Json& list, const StudyLog& log, const LoggedDesign* best) {
  const std::set<std::string> ids = unsettled_designs(log);
  int unsettled = 0, simulated = 0;
  for (const LoggedDesign& design : log.designs) {
    if (!design.ok) continue;
    ++simulated;
    unsettled += ids.contains(design.id) ? 1 : 0;
  }
  if (unsettled > 0) {
    const bool chosen = best != nullptr && ids.contains(best->id);
    list.push_back(fmt::format(
        "{} of {} designs{} ended at the stop time while the flow had not settled: retention and "
        "launch length may not be final. Allow a longer stop_time_s.",
        unsettled, simulated, chosen ? ", the recommended one among them," : ""));
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

/// How many lines of confirmations.jsonl there are for a design with a stage.
int confirmed_runs(const StudyLog& log, const LoggedDesign* best, const char* stage) {
  int count = 0;
  for (const LoggedDesign& run : log.confirmations) {
    count += best != nullptr && study::confirms(run.id, best->id) && run.stage == stage ? 1 : 0;
  }
  return count;
}

void add_spacings(Json& list, const StudyLog& log, const LoggedDesign* best) {
  std::set<double> spacings;
  for (const LoggedDesign& design : log.designs) {
    if (design.ok && design.spacing) spacings.insert(*design.spacing);
  }
  if (spacings.empty()) return;
  const bool refined = confirmed_runs(log, best, study::confirmation_stage::spacing) > 0;
  const std::string advice =
      refined ? "Results still change with refinement; how much, the run of the recommended design "
                "at another spacing shows."
              : "Results still change with refinement, so check the chosen design at a finer "
                "spacing (--confirm-spacing-mm) before relying on a margin.";
  const std::optional<double> counted = log.counted_spacing();
  if (spacings.size() == 1) {
    list.push_back(fmt::format("All designs were simulated at one particle spacing, {:g} mm. {}",
                               1000.0 * *spacings.begin(), advice));
  } else if (counted) {
    list.push_back(fmt::format("Only designs at a particle spacing of {:g} mm are compared. {}",
                               1000.0 * *counted, advice));
  } else {
    list.push_back(fmt::format(
        "Designs were simulated at {} different particle spacings ({:g} to {:g} mm); comparing "
        "them mixes the effect of the design with that of the resolution.",
        spacings.size(), 1000.0 * *spacings.begin(), 1000.0 * *spacings.rbegin()));
  }
  const auto levels = log.spec.value("/fidelity/spacings_m"_json_pointer, std::vector<double>{});
  if (counted && !levels.empty() && *std::ranges::min_element(levels) < *counted) {
    list.push_back(
        "No design was simulated at the study's finest spacing yet; those at the finest one used "
        "stand in for it.");
  }
}

void add_scatter(Json& list, const StudyLog& log, const LoggedDesign* best) {
  const int near = confirmed_runs(log, best, study::confirmation_stage::near);
  const std::string known =
      near > 0 ? fmt::format(
                     "How far a result moves under tiny changes is known from {} run{} near "
                     "the recommended design only.",
                     near, near == 1 ? "" : "s")
               : std::string(
                     "How far a result moves under tiny changes of the start has not been measured "
                     "for this study; close designs in its log show it.");
  list.push_back("The flow is chaotic after the impact. " + known +
                 " The best of many scattered values is also a little too good on average.");
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
  add_spacings(list, log, best);
  list.push_back(
      "The model is two-dimensional (a slice per metre width): flow around the barrier's "
      "ends, side walls and uneven beds are not in it.");
  add_scatter(list, log, best);
  if (uses_loads(log)) {
    list.push_back(
        "A force or moment decides here. Peak loads scatter far more than volumes, by tens of per "
        "cent between nearly equal designs at coarse spacings, and have not been validated against "
        "measurements.");
  }
  const bool scenarios = std::ranges::any_of(
      log.designs, [](const LoggedDesign& design) { return design.scenarios.size() > 1; });
  list.push_back(scenarios
                     ? "Only the scenarios listed were simulated; their weights are an input, and "
                       "the ranking of designs can change with them."
                     : "One debris material and one release volume were simulated; the ranking of "
                       "designs can change for others.");
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
