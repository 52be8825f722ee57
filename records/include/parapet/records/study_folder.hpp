/// A study on disk: study.json, evaluations.jsonl, evaluations/ID.json, summary.json, pareto.json
/// and surrogates.json.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/checksum_list.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/records/folder_lock.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/simulation.hpp"

namespace parapet::records {

/// What study.json says it is. The lines of the log beside it are of the same format. Version 1
/// knew no refused designs; it is read and continued.
constexpr const char* study_state_format = "parapet-study-state/2";
constexpr const char* early_study_state_format = "parapet-study-state/1";

/// Why study.json is none that this program reads; empty: it is one.
std::string state_problem(const designs::Json& state);

/// The physics numbers (solver::physics_number) by which the designs of a study were simulated, as
/// study.json says; a study of version 0.1.0 does not say it and has 1.
/// @throws designs::Json::type_error for anything but whole numbers
std::vector<int> physics_numbers(const designs::Json& state);

/// How a study's folder is opened.
struct FolderOptions {
  std::chrono::milliseconds patience{};  ///< how long to wait for another writer
  bool mix_physics = false;  ///< whether a study of another physics number may be continued
};

/// More refused designs are counted in summary.json and not logged.
constexpr std::size_t most_refused_designs = 10000;

/// A design that was stopped before all of its events were simulated.
struct UnfinishedDesign {
  std::string id;
  designs::Design design;
  double spacing = 0.0;                           ///< [m]
  std::map<std::string, Simulation> simulations;  ///< by scenario: those that ended
};

/// What a search was begun with. It decides the designs of a repeatable search, so it stays when
/// the study is continued with other values.
struct BegunWith {
  int jobs = 1;
  int max_evaluations = 0;
};

/// The folder of one study, locked for writing while this lives.
class StudyFolder {
 public:
  /// Creates the folder, or opens it when it belongs to the same study (see study_hash).
  /// @throws designs::InputError when it is not ours, belongs to another study, was begun with
  ///         another physics number, or is being written to. Nothing is changed then.
  /// @throws FileError
  StudyFolder(std::filesystem::path folder, const designs::StudySpec& study,
              const ProgramInfo& program, FolderOptions options = {});

  /// The log of the study.
  const EvaluationLog& log() const { return log_; }

  /// Notes in study.json what the search is begun with, unless it was begun before. Compares the
  /// files with checksums.sha256 (see notes) and removes it until close().
  /// @throws FileError
  void begin(const BegunWith& with);

  /// What the search was begun with.
  const BegunWith& begun_with() const { return begun_with_; }

  /// Writes evaluations/ID.json, then the log's line; both are on disk when it returns.
  /// @param report null leaves evaluations/ID.json out
  /// @throws FileError
  void store(const EvaluationRecord& record, const designs::Json& report);

  /// Writes evaluations/ID.json alone, ahead of the log's line. May be called from several threads
  /// at once.
  /// @throws FileError
  void store_report(const EvaluationRecord& record, const designs::Json& report) const;

  /// Writes the log's lines of designs whose reports are there.
  /// @throws FileError
  void store(const std::vector<EvaluationRecord>& records);

  /// Writes a refused design into the log, unless it stands there; no more than
  /// most_refused_designs.
  /// @throws FileError
  void store(RefusedDesign refused);

  /// Writes checksums.sha256: what was to be written has been.
  /// @throws FileError
  void close() const;

  /// Enters the files of one evaluation into checksums.sha256 and leaves the rest as it is.
  /// @throws FileError
  void close_after(const EvaluationRecord& record) const;

  /// Writes evaluations/ID-SCENARIO.json, so that a stop does not lose it. May be called from
  /// several threads at once.
  /// @param spacing particle spacing [m]
  /// @throws FileError
  void store_simulation(const std::string& id, const designs::Design& design, double spacing,
                        const designs::Scenario& scenario, const Simulation& simulation,
                        const designs::Json& provenance) const;

  /// Removes evaluations/ID-base.json, which held the simulation of a design without scenarios (one
  /// with an empty name) until the log had it.
  void discard_simulation(const std::string& id) const;

  /// Designs that an earlier run left behind incomplete, by id. Not changed by store().
  const std::vector<UnfinishedDesign>& unfinished() const { return unfinished_; }

  /// The simulation of one event of a design that an earlier run left incomplete; null when there
  /// is none.
  const Simulation* unfinished(const designs::Design& design, double spacing,
                               const std::string& scenario) const;

  /// Whether a design may take this id: no record has it, and no other incomplete design.
  bool id_is_free(const std::string& id, const designs::Design& design, double spacing) const;

  /// Replaces a JSON file of the folder, for example summary.json.
  /// @throws FileError
  void write(const std::string& file_name, const designs::Json& content) const;

  /// The folder.
  const std::filesystem::path& path() const { return folder_; }

  /// Sentences worth telling the user: a repaired log, another program version, and after begin()
  /// files that were changed.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::filesystem::path folder_;
  BegunWith begun_with_;
  std::vector<std::string> notes_;
  FolderLock lock_;
  EvaluationLog log_;
  std::optional<ChecksumList> checksums_;  // of a search that was begun
  std::vector<UnfinishedDesign> unfinished_;
};

}  // namespace parapet::records
