/// A whole study: optimise, log, summarise; resume when it was begun before.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/study/hooks.hpp"
#include "parapet/study/local_service.hpp"

namespace parapet::study {

/// Where a study runs, and who simulates.
struct StudyRunOptions {
  std::filesystem::path folder;
  int jobs = 1;  ///< simulations side by side
  records::ProgramInfo program;
  bool mix_physics = false;  ///< whether to continue a study of another physics number
  Hooks hooks;
  ServiceFactory service = local_service();  ///< who simulates
  /// Whether the event is simulated without barriers first (make_undisturbed).
  bool undisturbed = false;
};

/// How far a study is.
enum class StudyState { running, done, interrupted, failed };

/// The name as summary.json spells it.
std::string to_string(StudyState state);

/// The content of summary.json.
struct StudySummary {
  StudyState state = StudyState::running;
  std::string termination;  ///< optimizer::Termination in words, or "cpu_time_limit"; empty while
                            ///< running
  std::string message;
  int evaluations = 0;  ///< designs in the log
  int simulated = 0;    ///< of these, by this run of the program
  int cache_hits = 0;   ///< designs the optimiser asked for again
  int rejected = 0;     ///< designs refused by constraints that need no simulation
  std::optional<records::EvaluationRecord> best;           ///< feasible; lowest objective_scalar
  std::optional<records::EvaluationRecord> starting_best;  ///< the same among the starting designs
  /// The Pareto set: feasible designs at the finest spacing that no other dominates, by id.
  std::vector<records::EvaluationRecord> pareto;
  double hypervolume = 0.0;              ///< that they dominate, see Front
  std::optional<double> optimizer_time;  ///< that the search itself took in this run [s]
  double elapsed = 0.0;                  ///< of this run of the program [s]
};

/// Runs or resumes the study in its folder and keeps summary.json up to date; pareto.json, and with
/// surrogates surrogates.json, at least every ten records.
///
/// The algorithm BAYESIAN runs `jobs` simulations side by side and asks for a design whenever a
/// worker is free. With one job, or method.repeatable, an interrupted study ends, once resumed,
/// exactly where an undisturbed one does; else what is logged is told first, and the search goes
/// on from there. Designs of experiments are simulated in order. NLopt's algorithms always replay.
/// @throws designs::InputError for a method that cannot do what the spec asks, another study's
///         folder or a damaged log; records::FileError when the file system refuses.
StudySummary run_study(const designs::StudySpec& study, const StudyRunOptions& options);

/// As summary.json holds it, format "parapet-study-summary/1".
designs::Json to_json(const StudySummary& summary, const designs::StudySpec& study);

}  // namespace parapet::study
