#include "parapet/study/loaded_study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "companion_file.hpp"
#include "parapet/designs/text.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/checksum_list.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/records/study_folder.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/study_surrogates.hpp"
#include "parapet/study/undisturbed.hpp"

namespace parapet::study {
namespace {

using designs::InputError;
using designs::Json;
using records::EvaluationRecord;

Json read_state(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) {
    throw InputError({{.file = file.string(),
                       .pointer = "",
                       .value = "",
                       .problem = "the file is missing",
                       .allowed = "a study folder, as `parapet optimize` writes it"}});
  }
  Json state = designs::parse_json(records::read_own_file(file), file.string());
  if (const std::string problem = records::state_problem(state); !problem.empty()) {
    const Json format = state.is_object() ? state.value("format", Json()) : Json();
    throw InputError({{.file = file.string(),
                       .pointer = "/format",
                       .value = format.is_null() ? "" : format.dump(),
                       .problem = problem,
                       .allowed = fmt::format("\"{}\"", records::study_state_format)}});
  }
  return state;
}

/// What `read` gives; a file that does not hold what it should is named.
template <typename Read>
auto reading(const std::filesystem::path& file, Read read) {
  try {
    return read();
  } catch (const Json::exception& error) {
    designs::throw_misread(file, error);
  }
}

/// "running", "done" ...; empty when it is not known.
std::string read_run_state(const std::filesystem::path& file) {
  const Json summary = read_quietly(file);
  return summary.is_null() ? "" : summary.value("state", "");
}

/// What does not fit the spec; empty when all does. A failed design has no objectives.
std::string misfit(const designs::StudySpec& spec, const EvaluationRecord& record) {
  for (const designs::Variable& variable : spec.variables) {
    if (!record.design.contains(variable.name) && !variable.active_when) {
      return "there is no " + variable.name;
    }
  }
  if (!record.ok) return "";
  const auto same = [](const designs::Objective& stated, const records::ObjectiveRecord& one) {
    return objective_name(stated) == one.metric;
  };
  if (!std::ranges::equal(spec.objectives, record.objectives, same)) {
    return "its objectives are not those of the spec";
  }
  const bool same_constraints =
      std::ranges::equal(spec.constraints, record.constraints, {}, &designs::Constraint::name,
                         &records::ConstraintRecord::name);
  return same_constraints ? "" : "its constraints are not those of the spec";
}

/// Whether a file is written by parapet recommend: it is written again, so its damage matters to
/// nobody.
bool is_advice(const std::string& name) {
  return name.ends_with(".png") || name.starts_with("recommendation.") ||
         name == "sensitivity.json";
}

void add_damage(LoadedStudy& study, const records::LogContent& content,
                const std::filesystem::path& file) {
  for (const records::DamagedLine& line : content.damaged) {
    study.damage.push_back(to_string(line, file) + "; it is left out");
  }
  const std::string note = checksum_note(content, file);
  if (!note.empty()) study.notes.push_back(note);
}

void read_designs(LoadedStudy& study) {
  const std::filesystem::path file = study.folder / "evaluations.jsonl";
  const auto refuse = [&](const std::string& value, const std::string& problem,
                          const std::string& allowed) {
    throw InputError({{file.string(), "", value, problem, allowed}});
  };
  if (!std::filesystem::exists(file)) {
    refuse("", "the file is missing", "the log of a study that has started");
  }
  records::LogContent content = records::read_evaluation_log(file);
  study.designs = std::move(content.records);
  study.log_complete = !content.incomplete_last_line;
  add_damage(study, content, file);
  if (study.designs.empty()) {
    refuse("", "no design has been evaluated yet", "at least one complete line");
  }
  for (const EvaluationRecord& record : study.designs) {
    const std::string problem = misfit(study.spec, record);
    if (!problem.empty()) refuse("design " + record.id, problem, "designs of study.json's spec");
  }
}

/// Of designs with an estimate for each objective.
std::optional<StoredFront> read_front(const LoadedStudy& study) {
  auto front = read_stored_front(study.folder / "pareto.json", study.spec_hash);
  const auto fits = [&](const DesignEstimates& one) {
    return one.objectives.size() == study.spec.objectives.size();
  };
  return front && std::ranges::all_of(front->designs, fits) ? front : std::nullopt;
}

/// Whether a line says why its simulations ended; lines of earlier versions do not.
bool says_why_it_ended(const EvaluationRecord& record) {
  return !record.stop_reason.empty() ||
         std::ranges::any_of(record.scenarios,
                             [](const auto& scenario) { return !scenario.stop_reason.empty(); });
}

bool ended_at_stop_time(const EvaluationRecord& record) {
  return record.stop_reason == "end_time" ||
         std::ranges::any_of(record.scenarios, [](const auto& scenario) {
           return scenario.stop_reason == "end_time";
         });
}

/// From the reports of single simulations, for logs whose lines do not say it: the base event's
/// stands in evaluations/ID.json, a scenario's in evaluations/ID-SCENARIO.json.
std::set<std::string> unsettled_in_reports(const std::filesystem::path& folder) {
  std::set<std::string> ids;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".json") continue;
    const Json report = read_quietly(entry.path());
    for (const char* place : {"/simulation/stop_reason", "/details/simulation/stop_reason"}) {
      const Json::json_pointer pointer(place);
      if (!report.is_null() && report.contains(pointer) && report.at(pointer) == "end_time") {
        ids.insert(name.substr(0, name.find('-')));
      }
    }
  }
  return ids;
}

std::set<std::string> unsettled_designs(const LoadedStudy& study) {
  std::set<std::string> ids;
  if (!std::ranges::all_of(study.designs, says_why_it_ended)) {
    ids = unsettled_in_reports(study.folder / "evaluations");
  }
  for (const EvaluationRecord& record : study.designs) {
    if (ended_at_stop_time(record)) ids.insert(record.id);
  }
  return ids;
}

}  // namespace

std::vector<EvaluationRecord> load_confirmations(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "confirmations.jsonl";
  if (!std::filesystem::exists(file)) return {};
  return records::read_evaluation_log(file).records;
}

LoadedStudy load_study_folder(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "study.json";
  records::refuse_links(folder);
  const Json state = read_state(file);
  LoadedStudy study = reading(file, [&] {
    return LoadedStudy{
        .folder = folder,
        .spec = designs::parse_study(
            designs::with_present_names(designs::with_visible_texts(state.value("spec", Json()))),
            file.string() + " /spec"),
        .spec_hash = state.value("spec_hash", ""),
        .provenance = state.value("provenance", Json()),
        .state = {},
        .designs = {}};
  });
  study.spec.undisturbed = read_undisturbed(folder, study.spec);
  study.physics = reading(file, [&] { return records::physics_numbers(state); });
  if (study.physics.size() > 1) {
    study.notes.push_back(
        fmt::format("designs of different physics ({}) stand side by side in this study; their "
                    "numbers do not compare",
                    fmt::join(study.physics, ", ")));
  }
  const std::filesystem::path summary = folder / "summary.json";
  study.state = reading(summary, [&] { return read_run_state(summary); });
  read_designs(study);
  if (const auto log = folder / "confirmations.jsonl"; std::filesystem::exists(log)) {
    records::LogContent content = records::read_evaluation_log(log);
    add_damage(study, content, log);
    study.confirmations = std::move(content.records);
  }
  const records::ChecksumList checksums(folder);
  for (const std::string& name : checksums.damaged()) {
    if (!is_advice(name)) study.damage.push_back(checksums.note(name));
  }
  if (std::ranges::count(checksums.damaged(), "pareto.json") == 0) {
    study.front = reading(folder / "pareto.json", [&] { return read_front(study); });
  }
  if (std::ranges::count(checksums.damaged(), "surrogates.json") == 0) {
    const std::filesystem::path surrogates = folder / "surrogates.json";
    study.surrogates = reading(surrogates, [&] {
      return StudySurrogates::read(study.spec, surrogates, study.spec_hash, study.designs);
    });
  }
  const std::filesystem::path sensitivity = folder / "sensitivity.json";
  study.sensitivity =
      reading(sensitivity, [&] { return read_sensitivity(sensitivity, study.spec_hash); });
  study.unsettled = unsettled_designs(study);
  return study;
}

}  // namespace parapet::study
