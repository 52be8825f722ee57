#include "sweep_row_file.hpp"

#include "parapet/reports/atomic_file.hpp"
#include "parapet/reports/result_json.hpp"
#include "parapet/study/hashes.hpp"

namespace parapet::study {
namespace {

using designs::InputError;
using designs::Json;

reports::SweepRowResult row_from_json(const Json& json, const designs::SweepRow& row) {
  reports::SweepRowResult result;
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
  result.steps = json.at("/statistics/steps"_json_pointer).get<std::int64_t>();
  result.wall_time = json.at("/timing/wall_time_s"_json_pointer).get<double>();
  return result;
}

}  // namespace

std::optional<reports::SweepRowResult> read_finished_row(const std::filesystem::path& folder,
                                                         const designs::SweepRow& row,
                                                         const reports::ProgramInfo& program) {
  const std::filesystem::path file = folder / (row.id + ".json");
  if (!std::filesystem::exists(file)) return std::nullopt;
  const Json json = designs::read_json(file);
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
    if (version != program.version) return std::nullopt;
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
                        const solver::Result& result, const reports::ProgramInfo& program,
                        int threads) {
  const Json provenance = reports::provenance_json(program, case_hash(row.spec), row.spec.numerics);
  reports::write_file_atomically(folder / (row.id + ".csv"), reports::series_csv(result.series));
  reports::write_file_atomically(folder / (row.id + ".json"),
                                 reports::json_text(reports::result_json(
                                     row.id, result, row.spec.resolved, provenance, threads)));
}

}  // namespace parapet::study
