/// What a flow goes on from: taken from one flow, given to another with the same material, numerics
/// and particles, and the same solids as far as any particle has seen them.
#pragma once

#include <vector>

#include "parapet/flow/fluid.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::solver {

/// A particle that has left the domain.
struct Departure {
  std::int32_t id;  ///< of the particle at release
  double mass;      ///< [kg/m]
  double x;         ///< where it left [m]
};

/// Where a time integration stands between two solves of the viscous step.
struct IntegrationClock {
  int steps = 0;             ///< since the last solve
  double since_solve = 0.0;  ///< [s]
};

/// The quantities of a flow that change from step to step, but for its particles.
struct FlowProgress {
  RunStatistics statistics;
  double sound_speed = 0.0;       ///< of the equation of state now [m/s]
  double flow_speed = 0.0;        ///< of the fastest particle that is not spray [m/s]
  double max_speed = 0.0;         ///< of the fastest particle [m/s]
  double max_acceleration = 0.0;  ///< [m/s2]
  double time = 0.0;              ///< [s]
  double time_step = 0.0;         ///< the last one [s]
  double left_mass = 0.0;         ///< of the departures [kg/m]
};

/// A flow between two steps.
struct FlowState {
  FlowProgress progress;
  IntegrationClock clock;
  std::vector<Departure> departures;
  Fluid fluid;  ///< compact
  /// Where the particles stood when the neighbour rows were built [n]; empty when they are due.
  std::vector<double> built_x, built_z;
  /// Where they stood when the pairs were picked [n or n + 1]; empty when the next step picks anew.
  std::vector<double> picked_x, picked_z;

  std::size_t bytes() const;  ///< of memory, about
};

}  // namespace parapet::solver
