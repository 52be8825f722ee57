/// A whole study: optimise, log, summarise; resume when it was begun before.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "parapet/designs/study_spec.hpp"
#include "parapet/reports/evaluation_log.hpp"
#include "parapet/reports/provenance.hpp"
#include "parapet/study/hooks.hpp"

namespace parapet::study {

struct StudyRunOptions {
  std::filesystem::path folder;
  int jobs = 1;
  reports::ProgramInfo program;
  Hooks hooks;
};

enum class StudyState { running, done, interrupted, failed };
std::string to_string(StudyState state);

/// The content of summary.json.
struct StudySummary {
  StudyState state = StudyState::running;
  std::string termination;  ///< optimizer::Termination in words; empty while running
  std::string message;
  int evaluations = 0;  ///< designs in the log
  int simulated = 0;    ///< of these, by this run of the program
  int cache_hits = 0;   ///< designs the optimiser asked for again
  int rejected = 0;     ///< designs refused by constraints that need no simulation
  std::optional<reports::EvaluationRecord> best;           ///< feasible; lowest objective_scalar
  std::optional<reports::EvaluationRecord> starting_best;  ///< the same among the starting designs
  double elapsed = 0.0;                                    ///< of this run of the program [s]
};

/// Runs or resumes the study in its folder and keeps summary.json up to date.
/// @throws designs::InputError for a method that cannot do what the spec asks, another study's
///         folder or a damaged log; reports::FileError when the file system refuses.
StudySummary run_study(const designs::StudySpec& study, const StudyRunOptions& options);

designs::Json to_json(const StudySummary& summary, const designs::StudySpec& study);

}  // namespace parapet::study
