/// How one task is simulated on this machine: by the solver, or whatever stands in for it.
#pragma once

#include <functional>
#include <string>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/simulation.hpp"
#include "parapet/solver/simulation.hpp"
#include "parapet/study/simulation_task.hpp"

namespace parapet::study {

/// Simulates a task on the calling thread and returns when it has ended. Any number of calls may
/// run at once. A scene that cannot be simulated is a failed simulation, not an exception; the same
/// task gives the same metrics.
/// @param callbacks on_progress returns false to cancel
using Simulator = std::function<records::Simulation(const SimulationTask& task,
                                                    const solver::Callbacks& callbacks)>;

/// The solver.
Simulator solver_simulator();

/// The failed simulation of a design that gives an impossible scene.
/// @param why what make_task() or the solver said
records::Simulation impossible_scene(const std::string& why);

/// Expected processor time of one simulation of the base case [s], for a search that has seen none
/// yet. Only how it depends on the spacing matters: the search learns the rest.
double expected_seconds(const designs::StudySpec& study, double spacing);

/// Processor time that a simulation of so many particle steps takes on an ordinary core [s]. Stands
/// for the measured time where a decision must not depend on the clock.
double nominal_seconds(double particle_steps);

}  // namespace parapet::study
