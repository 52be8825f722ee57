#include "parapet/study/study_folder.hpp"

#include "parapet/reports/atomic_file.hpp"
#include "parapet/reports/result_json.hpp"
#include "parapet/study/design_run.hpp"
#include "parapet/study/hashes.hpp"

namespace parapet::study {
namespace {

using designs::InputError;
using designs::Json;

constexpr const char* state_format = "parapet-study-state/1";

std::filesystem::path made(const std::filesystem::path& folder) {
  reports::make_folder(folder);
  return folder;
}

Json state_json(const designs::StudySpec& study, const reports::ProgramInfo& program) {
  Json json;
  json["format"] = state_format;
  json["name"] = study.name;
  json["spec_hash"] = study_hash(study);
  json["provenance"] = reports::provenance_json(program, study_hash(study));
  json["provenance"]["seed"] = study.method.seed;
  json["spec"] = study.resolved;
  return json;
}

/// study.json of the folder, or null when there is none yet.
/// @throws InputError when the folder holds a log but no readable study.json.
Json read_state(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "study.json";
  if (std::filesystem::exists(file)) return designs::read_json(file);
  if (std::filesystem::exists(folder / "evaluations.jsonl")) {
    throw InputError({{.file = file.string(),
                       .pointer = "",
                       .value = "",
                       .problem = "is missing beside evaluations.jsonl",
                       .allowed = "a study folder, or another --out"}});
  }
  return nullptr;
}

/// Refuses another study's folder before anything is written; gives notes on the same one's.
std::vector<std::string> prepare_folder(const std::filesystem::path& folder,
                                        const designs::StudySpec& study,
                                        const reports::ProgramInfo& program) {
  std::vector<std::string> notes;
  const Json wanted = state_json(study, program);
  const Json state = read_state(folder);
  if (!state.is_null()) {
    const bool ours = state.is_object() && state.value("format", Json()) == state_format;
    if (!ours || state.value("spec_hash", Json()) != wanted["spec_hash"]) {
      throw InputError(
          {{.file = (folder / "study.json").string(),
            .pointer = ours ? "/spec_hash" : "/format",
            .value = ours ? state.value("spec_hash", Json()).dump() : "",
            .problem = "the folder belongs to another study" +
                       (ours && state.contains("name") ? " (" + state["name"].dump() + ")" : ""),
            .allowed = "the folder of this study (" + wanted["spec_hash"].dump() +
                       ") or a new one; choose it with --out"}});
    }
    const Json before = state.value("/provenance/program_version"_json_pointer, Json());
    if (before != program.version) {
      notes.push_back("this study was begun with version " + before.dump() +
                      " of the program; what it evaluated is kept");
    }
  }
  if (state != wanted) {
    reports::write_file_atomically(folder / "study.json", reports::json_text(wanted));
  }
  return notes;
}

}  // namespace

StudyFolder::StudyFolder(std::filesystem::path folder, const designs::StudySpec& study,
                         const reports::ProgramInfo& program, std::chrono::milliseconds patience)
    : folder_(std::move(folder)),
      lock_(made(folder_), patience),
      log_((notes_ = prepare_folder(folder_, study, program), folder_ / "evaluations.jsonl")) {
  reports::make_folder(folder_ / "evaluations");
  if (!log_.repair_note().empty()) notes_.push_back(log_.repair_note());
}

void StudyFolder::store(const reports::EvaluationRecord& record, const Json& report) {
  reports::write_file_atomically(folder_ / "evaluations" / (record.id + ".json"),
                                 reports::json_text(evaluation_report(record, report)));
  log_.append(record);
}

void StudyFolder::write_summary(const Json& summary) const {
  reports::write_file_atomically(folder_ / "summary.json", reports::json_text(summary));
}

}  // namespace parapet::study
