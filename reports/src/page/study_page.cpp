#include <algorithm>
#include <cmath>

#include "page_html.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/file_name.hpp"
#include "parapet/reports/recommendation_json.hpp"
#include "parapet/study/comparable.hpp"
#include "parapet/study/record_flows.hpp"
#include "parapet/study/sensitivity.hpp"
#include "parapet/study/slices.hpp"
#include "run_blocks.hpp"

namespace parapet::reports {
namespace {

using designs::Json;
using records::EvaluationRecord;

constexpr std::size_t most_drawn_designs = 300;  // scenes take a millisecond each
constexpr std::size_t most_designs_with_series = 64;

Json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json variable_value(const designs::Variable& variable, const EvaluationRecord& record) {
  const auto found = record.design.find(variable.name);
  if (found == record.design.end()) return nullptr;
  if (variable.kind != designs::VariableKind::choice) return found->second;
  return variable.options.at(static_cast<std::size_t>(found->second)).name;
}

/// A list per quantity, in the order of the log.
Json designs_json(const study::LoadedStudy& study, const Recommendation& advice) {
  Json json{{"id", Json::array()},          {"stage", Json::array()},
            {"spacing_m", Json::array()},   {"status", Json::array()},
            {"reason", Json::array()},      {"feasible", Json::array()},
            {"front", Json::array()},       {"stop_reason", Json::array()},
            {"warnings", Json::array()},    {"variables", Json::object()},
            {"objectives", Json::object()}, {"constraints", Json::object()},
            {"metrics", Json::object()}};
  std::set<std::string> front;
  for (const FrontDesign& one : advice.front) front.insert(one.id);
  if (advice.study.objectives.size() == 1 && advice.recommended) {
    front.insert(advice.recommended->design.id);
  }
  const std::size_t n = study.designs.size();
  const auto column = [&](const char* group, const std::string& name) -> Json& {
    Json& list = json[group][name];
    if (list.is_null()) list = Json(std::vector<Json>(n));
    return list;
  };
  for (std::size_t row = 0; row < n; ++row) {
    const EvaluationRecord& record = study.designs[row];
    json["id"].push_back(record.id);
    json["stage"].push_back(record.stage);
    json["spacing_m"].push_back(record.spacing);
    json["status"].push_back(record.ok ? "ok" : "failed");
    json["reason"].push_back(record.reason);
    json["feasible"].push_back(record.feasible);
    json["front"].push_back(front.contains(record.id));
    json["stop_reason"].push_back(record.stop_reason);
    Json warnings = Json::array();
    if (study.unsettled.contains(record.id)) {
      warnings.push_back("the simulation ended before the flow had settled");
    }
    json["warnings"].push_back(std::move(warnings));
    for (const designs::Variable& variable : study.spec.variables) {
      column("variables", variable.name)[row] = variable_value(variable, record);
    }
    for (const records::ObjectiveRecord& one : record.objectives) {
      column("objectives", one.metric)[row] = number(one.value);
    }
    for (const records::ConstraintRecord& one : record.constraints) {
      column("constraints", one.name)[row] = number(one.value);
    }
    for (const solver::Metric& one : record.metrics) {
      column("metrics", one.key)[row] = number(one.value);
    }
  }
  return json;
}

void add_keys(Json& page, const study::LoadedStudy& study) {
  for (const designs::Variable& one : study.spec.variables) add_key(page, one.name);
  for (const designs::Objective& one : study.spec.objectives) {
    add_key(page, one.name);
    if (!one.metric.empty()) add_key(page, one.metric);
  }
  for (const designs::Constraint& one : study.spec.constraints) {
    add_key(page, one.name);
    if (!one.metric.empty()) add_key(page, one.metric);
  }
  for (const EvaluationRecord& record : study.designs) {
    for (const solver::Metric& metric : record.metrics) add_key(page, metric.key);
  }
  // A limit on a metric has its unit, whatever it is called.
  for (const designs::Constraint& one : study.spec.constraints) {
    if (!one.metric.empty()) page["keys"][one.name]["unit"] = page["keys"][one.metric]["unit"];
  }
  for (const designs::Objective& one : study.spec.objectives) {
    if (!one.metric.empty()) page["keys"][one.name]["unit"] = page["keys"][one.metric]["unit"];
  }
}

/// Designs in the order in which they get room: asked for, recommended, front, then by rank.
std::vector<const EvaluationRecord*> by_interest(const study::LoadedStudy& study,
                                                 const Recommendation& advice,
                                                 const PageOptions& options) {
  std::vector<std::string> ids = options.first;
  if (const DesignReport* shown = advice.shown()) ids.push_back(shown->id);
  for (const FrontDesign& one : advice.front) ids.push_back(one.id);
  if (advice.improvement) ids.push_back(advice.improvement->start_id);
  for (const bool feasible : {true, false}) {
    for (const EvaluationRecord* one : study::ranked_designs(study, feasible)) {
      ids.push_back(one->id);
    }
  }
  std::vector<const EvaluationRecord*> list;
  std::set<std::string> taken;
  const auto take = [&](const EvaluationRecord& record) {
    if (taken.insert(record.id).second) list.push_back(&record);
  };
  std::map<std::string, const EvaluationRecord*> by_id;
  for (const EvaluationRecord& one : study.designs) by_id[one.id] = &one;
  for (const std::string& id : ids) {
    if (const auto found = by_id.find(id); found != by_id.end()) take(*found->second);
  }
  for (const EvaluationRecord& one : study.designs) take(one);
  return list;
}

/// The series of a design; null where they are not kept.
Json stored_series(const std::filesystem::path& folder, const std::string& id) {
  const std::filesystem::path file = folder / "evaluations" / (records::file_name(id) + ".json");
  std::error_code none;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, none)))
    return nullptr;
  try {
    const Json json = Json::parse(records::read_own_file(file), nullptr, false);
    if (json.is_object() && json.contains("series") && json["series"].is_object()) {
      return json["series"];
    }
  } catch (const records::FileError&) {
  }
  return nullptr;
}

void add_runs(RunBlocks& runs, const study::LoadedStudy& study, const Recommendation& advice,
              const PageOptions& options) {
  const std::string report = "parapet report " + shell_word(study.folder.string());
  std::size_t place = 0;
  for (const EvaluationRecord* record : by_interest(study, advice, options)) {
    ++place;
    if (place > most_drawn_designs) break;
    try {
      runs.add_scene(
          record->id,
          designs::design_case(study.spec, record->design, nullptr, record->spacing).scene);
    } catch (const designs::InputError&) {
      continue;  // an impossible scene has no drawing
    }
    if (place <= most_designs_with_series) {
      if (const Json series = stored_series(study.folder, record->id); !series.is_null()) {
        runs.add_series(record->id, series);
      }
    }
    runs.add_recording(record->id, study::recording_file(study.folder, record->id),
                       report + " --record " + record->id, report + " --show " + record->id);
  }
}

Json slices_json(const study::LoadedStudy& study, const DesignReport& shown) {
  std::string source;
  const auto record = std::ranges::find(study.designs, shown.id, &EvaluationRecord::id);
  if (record == study.designs.end()) return nullptr;
  try {
    const Json surrogates = study::study_surrogates(study.spec, study.folder, source);
    if (surrogates.is_null()) return nullptr;
    Json metrics = Json::array();
    for (const study::MetricSlices& one :
         study::surrogate_slices(study.spec, surrogates, record->design)) {
      Json slices = Json::array();
      for (const study::Slice& slice : one.slices) {
        Json at = Json::array();
        for (const study::VariablePlace& place : slice.at) {
          std::visit([&](const auto& value) { at.push_back(value); }, place);
        }
        slices.push_back({{"variable", slice.variable},
                          {"at", std::move(at)},
                          {"median", slice.median},
                          {"lower_95", slice.lower_95},
                          {"upper_95", slice.upper_95}});
      }
      metrics.push_back({{"metric", one.metric}, {"slices", std::move(slices)}});
    }
    return {{"design", shown.id}, {"metrics", std::move(metrics)}};
  } catch (const Json::exception&) {
    return nullptr;  // damaged surrogates: `parapet recommend` says so
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

}  // namespace

std::string study_page(const study::LoadedStudy& study, const Recommendation& advice,
                       const PageOptions& options) {
  Json page = common_json("study", study.spec.name, study.spec_hash, options);
  page["description"] = study.spec.description;
  page["state"] = study.state;
  page["recommendation"] = recommendation_json(advice);
  page["variables"] = page["recommendation"]["study"]["variables"];
  page["objectives"] = page["recommendation"]["study"]["objectives"];
  page["finest_spacing_m"] = advice.study.counted_spacing;
  page["designs"] = designs_json(study, advice);
  add_keys(page, study);
  const DesignReport* shown = advice.shown();
  page["slices"] = shown != nullptr ? slices_json(study, *shown) : Json(nullptr);
  const std::string folder = shell_word(study.folder.string());
  add_command(page, "recommend a design and simulate it again", "parapet recommend " + folder);
  if (advice.reproduce) {
    add_command(page, "repeat the study", advice.reproduce->optimize);
    add_command(page, "simulate the design shown", advice.reproduce->evaluate);
  }
  add_command(page, "simulate stored designs again and compare bit by bit",
              "parapet verify " + folder);
  add_command(page, "check the files", "cd " + folder + " && sha256sum -c checksums.sha256");
  RunBlocks runs(page);
  add_runs(runs, study, advice, options);
  return page_html(page, runs.blocks());
}

}  // namespace parapet::reports
