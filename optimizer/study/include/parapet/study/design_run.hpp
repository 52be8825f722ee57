/// One design of a study: scene, simulation and score.
#pragma once

#include "parapet/designs/study_spec.hpp"
#include "parapet/reports/evaluation_log.hpp"
#include "parapet/reports/provenance.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::study {

/// What became of a design. `record` lacks its id and stage, which the log gives.
struct DesignRun {
  bool cancelled = false;  ///< nothing else is meaningful then
  reports::EvaluationRecord record;
  designs::Json report;  ///< provenance, simulation, case and series
};

/// Simulates a design. An impossible scene, a failed simulation or an objective without a value
/// gives a failed record with the reason, not an exception.
/// @param threads at most so many, see worthwhile_threads
DesignRun run_design(const designs::StudySpec& study, const designs::Design& design,
                     const reports::ProgramInfo& program, int threads,
                     const solver::Callbacks& callbacks);

/// The content of evaluations/ID.json, format "parapet-evaluation/1".
designs::Json evaluation_report(const reports::EvaluationRecord& record,
                                const designs::Json& report);

}  // namespace parapet::study
