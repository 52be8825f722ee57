/// What a long run tells its caller, and how the caller stops it.
#pragma once

#include <functional>
#include <string>

#include "parapet/records/evaluation_log.hpp"
#include "parapet/solver/simulation.hpp"
#include "parapet/study/simulation_service.hpp"

namespace parapet::study {

/// All may be empty. on_simulation and cancelled are called from several threads at once, the
/// others from one at a time.
struct Hooks {
  std::function<bool()> cancelled;  ///< polled often; true ends the run soon
  /// How far a simulation is: of a sweep's row, of an evaluation's id, or with scenarios of
  /// "ID SCENARIO".
  std::function<void(const std::string& id, const solver::Progress& progress)> on_simulation;
  /// A simulation of a design has ended, well or not.
  std::function<void(const std::string& id)> on_simulation_ended;
  /// A design's record is known and on disk; from_log: nothing was simulated for it.
  std::function<void(const records::EvaluationRecord& record, bool from_log)> on_evaluated;
  /// After each record: designs in the Pareto set (of one objective: 1 when any is feasible) and
  /// the hypervolume that they dominate.
  std::function<void(int designs, double hypervolume)> on_front;
  std::function<void(const std::string& sentence)> on_message;
};

/// The part of them that a service needs; `hooks` must outlive it.
ServiceHooks service_hooks(const Hooks& hooks);

}  // namespace parapet::study
