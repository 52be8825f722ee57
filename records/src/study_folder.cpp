#include "parapet/records/study_folder.hpp"

#include <algorithm>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/file_name.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/records/whole_number.hpp"

namespace parapet::records {
namespace {

using designs::InputError;
using designs::Json;

const std::filesystem::path& opened(const std::filesystem::path& folder) {
  open_output_folder(folder, FolderKind::study);
  return folder;
}

Json state_json(const designs::StudySpec& study, const ProgramInfo& program) {
  Json json;
  json["format"] = study_state_format;
  json["name"] = study.name;
  json["spec_hash"] = study_hash(study);
  json["provenance"] = study_provenance(study, program);
  json["physics"] = {program.physics};
  json["spec"] = study.resolved;
  return json;
}

/// study.json of the folder, or null when there is none yet.
/// @throws InputError when the folder holds a log but no readable study.json.
Json read_state(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "study.json";
  if (std::filesystem::exists(file)) {
    return designs::parse_json(read_own_file(file), file.string());
  }
  if (std::filesystem::exists(folder / "evaluations.jsonl")) {
    throw InputError({{.file = file.string(),
                       .pointer = "",
                       .value = "",
                       .problem = "is missing beside evaluations.jsonl",
                       .allowed = "a study folder, or another --out"}});
  }
  return nullptr;
}

/// Whether the study would have this hash if the present version had begun it: keys that are new
/// since then, and defaults that have changed, make no other study. Other physics is another
/// matter.
bool same_but_for_new_defaults(const std::string& file, const Json& state, const Json& wanted) {
  try {
    const Json stored = designs::without_former_defaults(
        designs::with_present_names(state.at("spec")), wanted["spec"]);
    return study_hash(designs::parse_study(stored, file)) == wanted["spec_hash"];
  } catch (const std::exception&) {
    return false;
  }
}

void refuse_other_study(const std::string& file, const Json& state, const Json& wanted) {
  const std::string allowed = "the folder of this study (" + wanted["spec_hash"].dump() +
                              ") or a new one; choose it with --out";
  if (const std::string problem = state_problem(state); !problem.empty()) {
    const Json said = state.is_object() ? state.value("format", Json()) : Json();
    throw InputError({{file, "/format", said.is_null() ? "" : said.dump(), problem, allowed}});
  }
  const Json hash = state.value("spec_hash", Json());
  if (hash == wanted["spec_hash"] || same_but_for_new_defaults(file, state, wanted)) return;
  const std::string name = state.contains("name") ? " (" + state["name"].dump() + ")" : "";
  throw InputError(
      {{file, "/spec_hash", hash.dump(), "the folder belongs to another study" + name, allowed}});
}

/// The physics numbers of the study with this program's among them.
Json joined_physics(const std::string& file, const Json& state, int own, bool mix,
                    std::vector<std::string>& notes) {
  std::vector<int> numbers;
  try {
    numbers = physics_numbers(state);
  } catch (const Json::exception& error) {
    designs::throw_misread(file, error);
  }
  if (std::ranges::find(numbers, own) == numbers.end()) {
    if (!mix) {
      throw InputError({{file, "/physics", Json(numbers).dump(),
                         "the designs of this study were simulated with other physics than the " +
                             std::to_string(own) + " of this program: their numbers do not compare",
                         "a new folder (--out), or --mix-revisions to continue all the same"}});
    }
    numbers.push_back(own);
  }
  if (numbers.size() > 1) {
    notes.push_back("designs of different physics (" + Json(numbers).dump() +
                    ") stand side by side in this study; their numbers do not compare");
  }
  return numbers;
}

/// Refuses another study's folder before anything is written; gives notes on the same one's.
std::vector<std::string> prepare_folder(const std::filesystem::path& folder,
                                        const designs::StudySpec& study, const ProgramInfo& program,
                                        bool mix_physics) {
  std::vector<std::string> notes;
  Json wanted = state_json(study, program);
  const Json state = read_state(folder);
  if (!state.is_null()) {
    const std::string file = (folder / "study.json").string();
    refuse_other_study(file, state, wanted);
    wanted["physics"] = joined_physics(file, state, program.physics, mix_physics, notes);
    const Json before = state.value("/provenance/program_version"_json_pointer, Json());
    if (before != program.version) {
      notes.push_back("this study was begun with version " + before.dump() +
                      " of the program; what it evaluated is kept");
    } else {
      const Json revision = state.value("/provenance/git_revision"_json_pointer, Json());
      const Json ours_is = wanted.value("/provenance/git_revision"_json_pointer, Json());
      if (revision != ours_is) {
        notes.push_back("this study was begun with the revision " + revision.dump() +
                        " of the program, and this is " + ours_is.dump() +
                        "; what it evaluated is kept");
      }
    }
  }
  if (state.is_object() && state.contains("begun_with")) wanted["begun_with"] = state["begun_with"];
  if (state != wanted) {
    write_file_atomically(folder / "study.json", json_text(wanted));
    if (std::filesystem::exists(folder / checksum_list)) update_checksums(folder, {"study.json"});
  }
  return notes;
}

/// Of one simulation; that of a design without scenarios is the base event's.
std::string file_name_of(const std::string& id, const std::string& scenario) {
  return id + "-" + (scenario.empty() ? "base" : file_name(scenario)) + ".json";
}

/// A design whose line was damaged is to be simulated again: the report says which it was.
void add_damaged(std::map<std::string, UnfinishedDesign>& found,
                 const std::filesystem::path& folder, const EvaluationLog& log) {
  for (const DamagedLine& line : log.damaged()) {
    if (line.id.empty() || log.has_id(line.id) || found.contains(line.id)) continue;
    try {
      const Json report = Json::parse(read_own_file(folder / (line.id + ".json")));
      UnfinishedDesign design{.id = line.id,
                              .design = report.at("design").get<designs::Design>(),
                              .spacing = report.at("spacing_m").get<double>(),
                              .simulations = {}};
      if (log.find(design.design, design.spacing) == nullptr) found.emplace(line.id, design);
    } catch (const std::exception&) {
    }
  }
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
      StoredSimulation stored = stored_simulation(Json::parse(read_own_file(entry.path())));
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
  add_damaged(found, folder, log);
  std::vector<UnfinishedDesign> result;
  for (auto& [id, design] : found) result.push_back(std::move(design));
  return result;
}

}  // namespace

std::string state_problem(const Json& state) {
  const Json said = state.is_object() ? state.value("format", Json()) : Json();
  if (said == study_state_format || said == early_study_state_format) return "";
  if (!said.is_string() || !said.get<std::string>().starts_with("parapet-study-state/")) {
    return "this is not a study's state";
  }
  return std::string("a newer version of the program wrote this; this one reads up to ") +
         study_state_format;
}

std::vector<int> physics_numbers(const Json& state) {
  const Json stated = state.is_object() ? state.value("physics", Json()) : Json();
  std::vector<int> numbers;
  if (stated.is_array()) {
    for (const Json& one : stated) {
      numbers.push_back(whole_number<int>(one));
    }
  }
  return numbers.empty() ? std::vector<int>{1} : numbers;
}

StudyFolder::StudyFolder(std::filesystem::path folder, const designs::StudySpec& study,
                         const ProgramInfo& program, FolderOptions options)
    : folder_(std::move(folder)),
      lock_(opened(folder_), options.patience),
      log_((notes_ = prepare_folder(folder_, study, program, options.mix_physics),
            folder_ / "evaluations.jsonl")) {
  take_output_folder(folder_, FolderKind::study);
  make_folder(folder_ / "evaluations");
  for (const std::string& repair : log_.repairs()) notes_.push_back(repair);
  if (!log_.checksum_note().empty()) notes_.push_back(log_.checksum_note());
  unfinished_ = find_unfinished(folder_ / "evaluations", log_);
}

void StudyFolder::begin(const BegunWith& with) {
  const std::filesystem::path file = folder_ / "study.json";
  checksums_.emplace(folder_);
  for (const std::string& name : checksums_->damaged()) notes_.push_back(checksums_->note(name));
  checksums_->begin();
  Json state = designs::parse_json(read_own_file(file), file.string());
  if (!state.is_object()) state = Json::object();
  Json& begun = state["begun_with"];
  if (!begun.is_object()) {
    begun = {{"jobs", with.jobs}, {"max_evaluations", with.max_evaluations}};
    write_file_atomically(file, json_text(state));
  }
  try {
    const auto stated = [&](const char* key, int otherwise) {
      return begun.contains(key) ? whole_number<int>(begun[key]) : otherwise;
    };
    begun_with_ = {.jobs = stated("jobs", with.jobs),
                   .max_evaluations = stated("max_evaluations", with.max_evaluations)};
  } catch (const Json::exception& error) {
    designs::throw_misread(file, error);
  }
}

void StudyFolder::store(const EvaluationRecord& record, const Json& report) {
  if (!report.is_null()) store_report(record, report);
  log_.append(record);
}

void StudyFolder::store_report(const EvaluationRecord& record, const Json& report) const {
  write_file_atomically(folder_ / "evaluations" / (record.id + ".json"),
                        json_text(evaluation_report(record, report)));
}

void StudyFolder::store(const std::vector<EvaluationRecord>& records) {
  log_.append(records);
}

void StudyFolder::store(RefusedDesign refused) {
  if (log_.refused().size() < most_refused_designs) log_.append(std::move(refused));
}

void StudyFolder::close() const {
  if (checksums_) checksums_->write();
}

void StudyFolder::close_after(const EvaluationRecord& record) const {
  std::set<std::string> files{"study.json"};
  const std::string report = "evaluations/" + record.id + ".json";
  if (std::filesystem::exists(folder_ / report)) files.insert(report);
  for (const ScenarioRecord& scenario : record.scenarios) {
    const std::string file = "evaluations/" + file_name_of(record.id, scenario.name);
    if (std::filesystem::exists(folder_ / file)) files.insert(file);
  }
  update_checksums(folder_, files);
}

void StudyFolder::store_simulation(const std::string& id, const designs::Design& design,
                                   double spacing, const designs::Scenario& scenario,
                                   const Simulation& simulation, const Json& provenance) const {
  write_file_atomically(
      folder_ / "evaluations" / file_name_of(id, scenario.name),
      json_text(simulation_report(design, spacing, &scenario, simulation, provenance)));
}

void StudyFolder::discard_simulation(const std::string& id) const {
  std::error_code none;
  std::filesystem::remove(folder_ / "evaluations" / file_name_of(id, ""), none);
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
