/// What a simulation will cost, before it begins.
#pragma once

#include "parapet/solver/numerics.hpp"
#include "parapet/solver/scene.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::solver {

/// Counts that follow from the scene alone.
struct ExpectedCost {
  double particles = 0.0;      ///< at release
  double wall_points = 0.0;    ///< of all solids
  double neighbors = 0.0;      ///< slots of the neighbour rows, which are numbered with 32 bits
  double samples = 0.0;        ///< rows of the time series, at most
  double end_time = 0.0;       ///< when metrics are usually final [s]; at most the stop time
  double steps = 0.0;          ///< time steps until then
  double memory = 0.0;         ///< [bytes] at the peak, of one simulation
  double series_memory = 0.0;  ///< [bytes] of it: the time series

  /// Particles times time steps, to which the time of a run is nearly proportional.
  double particle_steps() const { return particles * steps; }
};

/// Preconditions: the scene, the numerics and the options are sound. Nothing is laid out.
ExpectedCost expected_cost(const Scene& scene, const Numerics& numerics, const RunOptions& options);

/// Slots of neighbour rows and wall points that 32-bit numbers can hold.
constexpr double most_numbered = 2147483647.0;

}  // namespace parapet::solver
