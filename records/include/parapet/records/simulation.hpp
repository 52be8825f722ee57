/// What one simulation of a design under one event gave, in memory and on disk.
#pragma once

#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::records {

/// Outcome of one simulation.
struct Simulation {
  bool ok = false;
  bool cancelled = false;   ///< nothing else is meaningful then
  std::string reason;       ///< why it failed: an impossible scene, or the solver's reason
  std::string stop_reason;  ///< "settled", "end_time" ...; empty when it never started
  std::vector<solver::Metric> metrics;
  double wall_time = 0.0;       ///< [s]
  double cpu_time = 0.0;        ///< processor time of all threads [s]
  double particle_steps = 0.0;  ///< particles released times time steps; repeatable, unlike a time
  std::vector<solver::Warning> warnings;  ///< what its result must not be read without
  designs::Json report;                   ///< details for evaluations/: simulation, case and series
};

/// As it stands in the log, beside the design's other events.
/// @param scenario null: the base event
ScenarioRecord scenario_record(const designs::Scenario* scenario, const Simulation& simulation);

/// A simulation together with what was simulated.
struct StoredSimulation {
  designs::Design design;
  double spacing = 0.0;  ///< particle spacing [m]
  std::string scenario;
  Simulation simulation;
};

/// The content of evaluations/ID-SCENARIO.json, format "parapet-simulation/1".
/// @param spacing particle spacing [m]
designs::Json simulation_report(const designs::Design& design, double spacing,
                                const designs::Scenario* scenario, const Simulation& simulation,
                                const designs::Json& provenance);

/// Reads such a file; one whose checksum is wrong is refused.
/// @throws std::runtime_error or nlohmann::json::exception saying what is wrong.
StoredSimulation stored_simulation(const designs::Json& json);

/// The content of evaluations/ID.json, format "parapet-evaluation/1".
designs::Json evaluation_report(const EvaluationRecord& record, const designs::Json& report);

}  // namespace parapet::records
