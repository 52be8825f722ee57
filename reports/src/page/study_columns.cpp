#include "study_columns.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/file_name.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/study/comparable.hpp"
#include "parapet/study/record_flows.hpp"

namespace parapet::reports {
namespace {

using designs::Json;
using records::EvaluationRecord;

Json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json variable_value(const designs::Variable& variable, const EvaluationRecord& record) {
  const auto found = record.design.find(variable.name);
  if (found == record.design.end()) return nullptr;
  if (variable.kind != designs::VariableKind::choice) return found->second;
  return variable.options.at(static_cast<std::size_t>(found->second)).name;
}

}  // namespace

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
    for (const solver::Warning& one : record.warnings) warnings.push_back(one.text);
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
    for (const records::TermRecord& one : record.terms) {
      column("terms", one.name)[row] = number(one.value);
    }
    for (const solver::Metric& one : record.metrics) {
      column("metrics", one.key)[row] = number(one.value);
    }
  }
  return json;
}

namespace {

/// As RFC 4180 has it: quoted where a comma, a quote or a line end stands in it.
std::string csv_cell(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  if (value.is_number()) return records::shortest_number(value.get<double>());
  const std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string designs_csv(const Json& columns) {
  std::vector<std::pair<std::string, const Json*>> shown;
  for (const char* key : {"id", "stage", "status", "reason", "feasible", "front", "spacing_m"}) {
    shown.emplace_back(key, &columns.at(key));
  }
  for (const auto& [group, prefix] :
       {std::pair("variables", "variable."), std::pair("objectives", "objective."),
        std::pair("constraints", "constraint."), std::pair("terms", "term."),
        std::pair("metrics", "metric.")}) {
    if (!columns.contains(group)) continue;  // a study without terms
    for (const auto& [name, column] : columns.at(group).items()) {
      shown.emplace_back(prefix + name, &column);
    }
  }
  std::string text;
  for (std::size_t c = 0; c < shown.size(); ++c) {
    if (c > 0) text += ',';
    text += csv_cell(shown[c].first);
  }
  text += '\n';
  for (std::size_t row = 0; row < columns.at("id").size(); ++row) {
    for (std::size_t c = 0; c < shown.size(); ++c) {
      if (c > 0) text += ',';
      text += csv_cell(shown[c].second->at(row));
    }
    text += '\n';
  }
  return text;
}

void add_study_keys(Json& page, const study::LoadedStudy& study) {
  for (const designs::Variable& one : study.spec.variables) add_key(page, one.name);
  for (const designs::Objective& one : study.spec.objectives) {
    add_key(page, one.name);
    if (!one.metric.empty()) add_key(page, one.metric);
  }
  for (const designs::Term& one : study.spec.terms) add_key(page, one.name);
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

namespace {

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

}  // namespace

void add_study_runs(RunBlocks& runs, const study::LoadedStudy& study, const Recommendation& advice,
                    const PageOptions& options, const StudyRoom& room, const std::string& prefix) {
  const std::string report = "parapet report " + shell_word(study.folder.string());
  std::size_t place = 0;
  for (const EvaluationRecord* record : by_interest(study, advice, options)) {
    ++place;
    if (place > room.drawn) break;
    try {
      const designs::CaseSpec spec =
          designs::design_case(study.spec, record->design, nullptr, record->spacing);
      runs.add_case(
          prefix + record->id, spec, [&](const std::string& key) -> std::optional<double> {
            const auto found = std::ranges::find(record->metrics, key, &solver::Metric::key);
            return found == record->metrics.end() ? std::nullopt : found->value;
          });
      if (place <= room.with_series) {
        if (const Json series = stored_series(study.folder, record->id); !series.is_null()) {
          runs.add_series(prefix + record->id, spec, series);
        }
      }
    } catch (const designs::InputError&) {
      continue;  // an impossible scene has no drawing
    }
    runs.add_recording(prefix + record->id, study::recording_file(study.folder, record->id),
                       report + " --record " + record->id, report + " --show " + record->id);
  }
}

}  // namespace parapet::reports
