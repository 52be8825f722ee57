#include <algorithm>
#include <memory>
#include <utility>

#include "parapet/designs/error.hpp"
#include "parapet/records/checksum_list.hpp"
#include "parapet/study/loaded_study.hpp"
#include "parapet/study/verify.hpp"

namespace parapet::study {
namespace {

using designs::InputError;
using designs::Json;

std::string program_of(const Json& provenance) {
  if (!provenance.is_object()) return "";
  const std::string version = provenance.value("program_version", "");
  const std::string revision = provenance.value("git_revision", "");
  return revision.empty() ? version : version + " (" + revision + ")";
}

/// Of a record of the base event: a design may have failed although its simulation did not.
std::optional<bool> simulation_ended_well(const records::EvaluationRecord& record) {
  for (const char* end : {"metrics_final", "settled", "end_time"}) {
    if (record.ok || record.stop_reason == end) return true;
  }
  return record.stop_reason.empty() ? std::nullopt : std::optional(false);
}

/// The stored runs of one design: one for each scenario, or the base event.
void add_design(const std::shared_ptr<const LoadedStudy>& study,
                const records::EvaluationRecord& record, std::vector<StoredRun>& runs) {
  StoredRun run;
  run.label = record.id;
  run.program = program_of(study->provenance);
  const auto task = [study, &record](const designs::Scenario* scenario, const std::string& label) {
    return make_task(study->spec, record.design, scenario, record.spacing, label, 1);
  };
  if (study->spec.scenarios.empty()) {
    run.ok = simulation_ended_well(record);
    run.reason = record.reason;
    run.metrics = record.metrics;
    run.task = [task, label = run.label] { return task(nullptr, label); };
    runs.push_back(std::move(run));
    return;
  }
  for (const records::ScenarioRecord& one : record.scenarios) {
    const auto found = std::ranges::find(study->spec.scenarios, one.name, &designs::Scenario::name);
    if (found == study->spec.scenarios.end()) continue;
    StoredRun event = run;
    event.label += " " + one.name;
    event.ok = one.ok;
    event.reason = one.reason;
    event.metrics = one.metrics;
    event.task = [task, scenario = &*found, label = event.label] { return task(scenario, label); };
    runs.push_back(std::move(event));
  }
}

bool was_simulated(const records::EvaluationRecord& record) {
  return record.particle_steps > 0.0 || !record.metrics.empty();
}

std::vector<StoredRun> runs_of_study(const std::filesystem::path& folder) {
  const auto study = std::make_shared<const LoadedStudy>(load_study_folder(folder));
  std::vector<StoredRun> runs;
  for (const records::EvaluationRecord& record : study->designs) {
    if (was_simulated(record)) add_design(study, record, runs);
  }
  return runs;
}

/// From a file of the format "parapet-result/1".
StoredRun run_of_result(const std::filesystem::path& file) {
  const Json json = designs::read_json(file);
  const auto refuse = [&](const std::string& problem) {
    return InputError({{.file = file.string(),
                        .pointer = "",
                        .value = "",
                        .problem = problem,
                        .allowed = "a result of this program (\"parapet-result/1\")"}});
  };
  if (!json.is_object() || json.value("format", Json()) != "parapet-result/1") {
    throw refuse("this is no result");
  }
  StoredRun run;
  try {
    run.label = file.filename() == "result.json" ? json.at("name").get<std::string>()
                                                 : file.stem().string();
    run.program = program_of(json.at("provenance"));
    run.ok = json.at("status") == "ok";
    run.reason = json.at("reason").get<std::string>();
    for (const auto& [key, value] : json.at("metrics").items()) {
      run.metrics.push_back(
          {key, value.is_null() ? std::nullopt : std::optional(value.get<double>()), ""});
    }
    run.task = [label = run.label, spec = json.at("case"), name = file.string()] {
      return task_from_case(designs::parse_case(spec, name + " /case"), label);
    };
  } catch (const Json::exception&) {
    throw refuse("a key is missing or of the wrong type");
  }
  return run;
}

std::vector<StoredRun> runs_of_sweep(const std::filesystem::path& rows) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(rows)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<StoredRun> runs;
  for (const auto& file : files) runs.push_back(run_of_result(file));
  return runs;
}

}  // namespace

std::vector<std::string> folder_damage(const std::filesystem::path& folder) {
  if (std::filesystem::exists(folder / "study.json")) return load_study_folder(folder).damage;
  const records::ChecksumList checksums(folder);
  std::vector<std::string> damage;
  for (const std::string& file : checksums.damaged()) damage.push_back(checksums.note(file));
  return damage;
}

std::vector<StoredRun> stored_runs(const std::filesystem::path& folder) {
  std::vector<StoredRun> runs;
  if (std::filesystem::exists(folder / "study.json")) {
    runs = runs_of_study(folder);
  } else if (std::filesystem::is_directory(folder / "rows")) {
    runs = runs_of_sweep(folder / "rows");
  } else if (std::filesystem::exists(folder / "result.json")) {
    runs = {run_of_result(folder / "result.json")};
  }
  if (!runs.empty()) return runs;
  throw InputError({{.file = folder.string(),
                     .pointer = "",
                     .value = "",
                     .problem = "there is nothing to verify here",
                     .allowed = "a folder of parapet optimize (study.json), table3 (rows/) or "
                                "simulate (result.json) in which something was simulated"}});
}

}  // namespace parapet::study
