#include "parapet/records/sweep_row_file.hpp"

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

void write_finished_row(const std::filesystem::path& folder, const designs::SweepRow& row,
                        const solver::Result& result, const ProgramInfo& program, int threads) {
  const Json provenance = provenance_json(program, case_hash(row.spec), row.spec.numerics);
  write_file_atomically(folder / (row.id + ".csv"), series_csv(result.series));
  write_file_atomically(
      folder / (row.id + ".json"),
      json_text(result_json(row.id, result, row.spec.resolved, provenance, threads)));
}

}  // namespace parapet::records
