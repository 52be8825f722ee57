#include "parapet/records/study_folder.hpp"

#include <algorithm>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/result_json.hpp"

namespace parapet::records {
namespace {

using designs::InputError;
using designs::Json;

constexpr const char* state_format = "parapet-study-state/1";

std::filesystem::path made(const std::filesystem::path& folder) {
  make_folder(folder);
  return folder;
}

Json state_json(const designs::StudySpec& study, const ProgramInfo& program) {
  Json json;
  json["format"] = state_format;
  json["name"] = study.name;
  json["spec_hash"] = study_hash(study);
  json["provenance"] = study_provenance(study, program);
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
                                        const ProgramInfo& program) {
  std::vector<std::string> notes;
  Json wanted = state_json(study, program);
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
  if (state.is_object() && state.contains("begun_with")) wanted["begun_with"] = state["begun_with"];
  if (state != wanted) {
    write_file_atomically(folder / "study.json", json_text(wanted));
  }
  return notes;
}

/// Letters, digits, '-', '_' and '.'; anything else becomes '_', and the number of the event then
/// keeps two names apart.
std::string file_name_of(const std::string& id, const std::string& scenario, std::size_t event) {
  std::string name = scenario;
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || c == '.';
    if (!plain) c = '_';
  }
  if (name != scenario) name.append("-").append(std::to_string(event + 1));
  return id + "-" + name + ".json";
}

/// The simulations in evaluations/ whose design is not in the log. What cannot be read is passed
/// over: it is simulated again.
std::vector<UnfinishedDesign> find_unfinished(const std::filesystem::path& folder,
                                              const EvaluationLog& log) {
  std::map<std::string, UnfinishedDesign> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const std::string id = name.substr(0, name.find('-'));
    if (id == name || entry.path().extension() != ".json" || log.has_id(id)) continue;
    try {
      StoredSimulation stored = stored_simulation(designs::read_json(entry.path()));
      if (log.find(stored.design, stored.spacing) != nullptr) continue;
      UnfinishedDesign& design = found[id];
      if (design.id.empty()) {
        design.id = id;
        design.design = std::move(stored.design);
        design.spacing = stored.spacing;
      } else if (design.design != stored.design || design.spacing != stored.spacing) {
        continue;
      }
      design.simulations.emplace(std::move(stored.scenario), std::move(stored.simulation));
    } catch (const std::exception&) {
    }
  }
  std::vector<UnfinishedDesign> result;
  for (auto& [id, design] : found) result.push_back(std::move(design));
  return result;
}

}  // namespace

StudyFolder::StudyFolder(std::filesystem::path folder, const designs::StudySpec& study,
                         const ProgramInfo& program, std::chrono::milliseconds patience)
    : folder_(std::move(folder)),
      lock_(made(folder_), patience),
      log_((notes_ = prepare_folder(folder_, study, program), folder_ / "evaluations.jsonl")) {
  make_folder(folder_ / "evaluations");
  if (!log_.repair_note().empty()) notes_.push_back(log_.repair_note());
  unfinished_ = find_unfinished(folder_ / "evaluations", log_);
}

void StudyFolder::begin(const BegunWith& with) {
  const std::filesystem::path file = folder_ / "study.json";
  Json state = designs::read_json(file);
  Json& begun = state["begun_with"];
  if (!begun.is_object()) {
    begun = {{"jobs", with.jobs}, {"max_evaluations", with.max_evaluations}};
    write_file_atomically(file, json_text(state));
  }
  begun_with_ = {.jobs = begun.value("jobs", with.jobs),
                 .max_evaluations = begun.value("max_evaluations", with.max_evaluations)};
}

void StudyFolder::store(const EvaluationRecord& record, const Json& report) {
  write_file_atomically(folder_ / "evaluations" / (record.id + ".json"),
                        json_text(evaluation_report(record, report)));
  log_.append(record);
}

void StudyFolder::store_simulation(const std::string& id, const designs::Design& design,
                                   double spacing, const designs::Scenario& scenario,
                                   std::size_t event, const Simulation& simulation,
                                   const Json& provenance) const {
  write_file_atomically(
      folder_ / "evaluations" / file_name_of(id, scenario.name, event),
      json_text(simulation_report(design, spacing, &scenario, simulation, provenance)));
}

const Simulation* StudyFolder::unfinished(const designs::Design& design, double spacing,
                                          const std::string& scenario) const {
  for (const UnfinishedDesign& one : unfinished_) {
    if (one.design != design || one.spacing != spacing) continue;
    const auto found = one.simulations.find(scenario);
    if (found != one.simulations.end()) return &found->second;
  }
  return nullptr;
}

bool StudyFolder::id_is_free(const std::string& id, const designs::Design& design,
                             double spacing) const {
  if (log_.has_id(id)) return false;
  return std::none_of(unfinished_.begin(), unfinished_.end(), [&](const UnfinishedDesign& one) {
    return one.id == id && (one.design != design || one.spacing != spacing);
  });
}

void StudyFolder::write(const std::string& file_name, const Json& content) const {
  write_file_atomically(folder_ / file_name, json_text(content));
}

}  // namespace parapet::records
