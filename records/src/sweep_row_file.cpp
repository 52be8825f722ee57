#include "parapet/records/sweep_row_file.hpp"

#include <limits>
#include <string>
#include <vector>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/records/whole_number.hpp"

namespace parapet::records {
namespace {

using designs::InputError;
using designs::Json;

SweepRowResult row_from_json(const Json& json, const designs::SweepRow& row) {
  SweepRowResult result;
  result.id = row.id;
  result.description = row.description;
  result.published = row.published;
  const bool ok = json.at("status").get<std::string>() == "ok";
  result.status = ok ? solver::Status::ok : solver::Status::failed;
  result.reason = json.at("reason").get<std::string>();
  for (const auto& [key, value] : json.at("metrics").items()) {
    result.metrics[key] = value.is_null() ? std::nullopt : std::optional(value.get<double>());
  }
  for (const auto& [key, why] : json.at("metrics_absent").items()) {
    result.metrics_absent[key] = why.get<std::string>();
  }
  result.stop_time = json.at("stop_time_s").get<double>();
  result.stop_reason = json.at("stop_reason").get<std::string>();
  result.steps = whole_number<std::int64_t>(json.at("/statistics/steps"_json_pointer));
  result.wall_time = json.at("/timing/wall_time_s"_json_pointer).get<double>();
  return result;
}

}  // namespace

std::optional<SweepRowResult> read_finished_row(const std::filesystem::path& folder,
                                                const designs::SweepRow& row,
                                                const ProgramInfo& program) {
  const std::filesystem::path file = folder / (row.id + ".json");
  if (!std::filesystem::exists(file)) return std::nullopt;
  const Json json = designs::parse_json(read_own_file(file), file.string());
  const std::string hash = case_hash(row.spec);
  try {
    const auto found = json.at("/provenance/spec_hash"_json_pointer).get<std::string>();
    if (found != hash) {
      throw InputError({{.file = file.string(),
                         .pointer = "/provenance/spec_hash",
                         .value = '"' + found + '"',
                         .problem = "this row was computed from another spec",
                         .allowed = "rows of this spec (\"" + hash +
                                    "\"), or a new folder; choose it with --out"}});
    }
    const auto version = json.at("/provenance/program_version"_json_pointer).get<std::string>();
    const int physics = whole_number<int>(json.value("/provenance/physics"_json_pointer, Json(1)));
    if (version != program.version || physics != program.physics) return std::nullopt;
    return row_from_json(json, row);
  } catch (const Json::exception& error) {
    throw InputError(
        {{.file = file.string(),
          .pointer = "",
          .value = "",
          .problem = std::string("is not a row's result: ") + error.what(),
          .allowed = "a file written by this program; remove it to run the row again"}});
  }
}

namespace {

/// What of a result stands in the report of its simulation. Of one that never began, or whose
/// process died, there is none: nothing was simulated then.
Json report_of(const Simulation& simulation) {
  if (simulation.report.is_object() && simulation.report.contains("simulation")) {
    return simulation.report["simulation"];
  }
  return {{"status", "failed"},
          {"reason", simulation.reason},
          {"stop_reason", simulation.stop_reason},
          {"stop_time_s", 0.0},
          {"quality", nullptr},
          {"warnings", Json::array()},
          {"mass", nullptr},
          {"statistics", {{"steps", 0}}},
          {"timing", {{"wall_time_s", simulation.wall_time}, {"threads", 1}}}};
}

/// The content of result.json.
Json row_json(const designs::SweepRow& row, const Simulation& simulation, const Json& provenance) {
  const Json report = report_of(simulation);
  solver::Result result;  // of which only the metrics are told
  result.metrics = simulation.metrics;
  Json json;
  json["format"] = "parapet-result/1";
  json["name"] = row.id;
  for (const char* key : {"status", "reason", "stop_reason", "stop_time_s"}) {
    json[key] = report.at(key);
  }
  json["metrics"] = metrics_json(result);
  json["metrics_absent"] = metrics_absent_json(result);
  if (Json unknown = metrics_unknown_json(result.metrics); !unknown.empty()) {
    json["metrics_unknown"] = std::move(unknown);
  }
  for (const char* key : {"quality", "warnings", "mass", "statistics"}) json[key] = report.at(key);
  json["provenance"] = provenance;
  json["timing"] = report.at("timing");
  json["case"] = row.spec.resolved;
  return json;
}

/// series.csv from the JSON form of the series.
std::string csv_of(const Json& series) {
  solver::Series table;
  if (series.is_object()) {
    table.columns = series.at("columns").get<std::vector<std::string>>();
    for (const Json& row : series.at("rows")) {
      std::vector<double>& values = table.rows.emplace_back();
      for (const Json& value : row) {
        values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                         : value.get<double>());
      }
    }
  }
  return series_csv(table);
}

}  // namespace

void write_finished_row(const std::filesystem::path& folder, const designs::SweepRow& row,
                        const Simulation& simulation, const ProgramInfo& program) {
  const Json provenance = provenance_json(program, case_hash(row.spec), row.spec);
  const Json series =
      simulation.report.is_object() ? simulation.report.value("series", Json()) : Json();
  write_file_atomically(folder / (row.id + ".csv"), csv_of(series));
  write_file_atomically(folder / (row.id + ".json"),
                        json_text(row_json(row, simulation, provenance)));
}

SweepRowResult make_sweep_row_result(const designs::SweepRow& row, const Simulation& simulation) {
  return row_from_json(row_json(row, simulation, nullptr), row);
}

}  // namespace parapet::records
