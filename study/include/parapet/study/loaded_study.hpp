/// A study folder as types, read once: what advice is made from.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/sensitivity_file.hpp"
#include "parapet/study/stored_front.hpp"

namespace parapet::study {

class StudySurrogates;

/// A study folder, read as types.
struct LoadedStudy {
  std::filesystem::path folder;
  designs::StudySpec spec;
  std::string spec_hash;                           ///< as study.json states it
  designs::Json provenance;                        ///< likewise; null when not recorded
  std::string state;                               ///< of summary.json; empty when there is none
  std::vector<records::EvaluationRecord> designs;  ///< evaluations.jsonl, at least one
  bool log_complete = true;              ///< false: a half-written last line was passed over
  std::vector<std::string> damage = {};  ///< a sentence for each damaged line, which is left out,
                                         ///< and for each file that is not what was written
  std::vector<int> physics = {1};        ///< by which its designs were simulated
  std::vector<std::string> notes = {};   ///< sentences about lines without checksums
  std::vector<records::EvaluationRecord> confirmations = {};  ///< confirmations.jsonl
  std::optional<StoredFront> front = {};                      ///< pareto.json
  std::optional<Sensitivity> sensitivity = {};                ///< sensitivity.json
  /// Ids of designs with a simulation that ended at the stop time, before the flow had settled.
  std::set<std::string> unsettled = {};
  std::shared_ptr<const StudySurrogates> surrogates = {};  ///< surrogates.json; null without
};

/// Reads study.json and evaluations.jsonl, and what else is there; changes nothing. A half-written
/// last line (the study was killed, or still runs) is passed over, and so are damaged lines, with a
/// sentence in `damage`. pareto.json and sensitivity.json
/// are passed over when they are damaged or of another study.
/// @throws designs::InputError naming file and place of what is missing or damaged, when nothing
///         was evaluated yet, and when the log is not that of the spec
LoadedStudy load_study_folder(const std::filesystem::path& folder);

/// The whole sound lines of confirmations.jsonl; none without the file.
std::vector<records::EvaluationRecord> load_confirmations(const std::filesystem::path& folder);

}  // namespace parapet::study
