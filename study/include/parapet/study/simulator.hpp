/// How a study simulates one event of one design: the solver, or whatever stands in for it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/simulation.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::study {

/// What is to be simulated. All that is referred to outlives the call.
struct SimulationTask {
  const designs::StudySpec& study;
  const designs::Design& design;
  const designs::Scenario* scenario = nullptr;  ///< null: the base event
  double spacing = 0.0;                         ///< particle spacing [m]
  int threads = 1;                              ///< at most so many
  const solver::Callbacks& callbacks;
};

/// Any number of calls may run at once. A design that cannot be simulated is a failed simulation,
/// not an exception; the same task gives the same metrics.
using Simulator = std::function<records::Simulation(const SimulationTask& task)>;

/// The solver.
Simulator solver_simulator();

/// Expected processor time of one simulation of the base case [s], for a search that has seen none
/// yet. Only how it depends on the spacing matters: the search learns the rest.
double expected_seconds(const designs::StudySpec& study, double spacing);

/// Processor time that a simulation of so many particle steps takes on an ordinary core [s]. Stands
/// for the measured time where a decision must not depend on the clock.
double nominal_seconds(double particle_steps);

}  // namespace parapet::study
