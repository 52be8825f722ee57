/// The largest stable time step: acoustic, body force, and viscous when viscosity is explicit.
#pragma once

#include <cstddef>

#include "parapet/solver/numerics.hpp"

namespace parapet::solver {

/// What the limits depend on beside the numerics.
struct TimeStepInput {
  double smoothing_length;  ///< h [m]
  double max_speed;         ///< [m/s]
  double max_acceleration;  ///< [m/s2]
  double max_viscosity;     ///< [Pa s]; 0 when viscosity is implicit
  double density;           ///< [kg/m3]
  double acoustic_cfl;      ///< the numerics', or the integrator's own
};

/// min(cfl h/(c_s + u), cfl sqrt(h/a), cfl h^2 rho/eta) [s].
double stable_time_step(const Numerics& numerics, const TimeStepInput& input);

/// Courant number of implicit_viscosity, and the share by which a step of it may exceed the stable
/// one so that samples fall on their times. On a lattice 1.36 is stable.
constexpr double implicit_acoustic_cfl = 1.1;
constexpr double implicit_step_excess = 0.1;

/// The step with which a whole number of equal steps covers `longest` [s]: as many as the stable
/// step needs, or one fewer where that makes them longer than it by no more than the share
/// `most_excess`. Asked again before every step, it keeps to a number of steps while the stable
/// step wavers, so that no short step is left over at the end.
double dividing_step(double longest, double stable, double most_excess);

/// Which of the three limits decides.
enum class TimeStepLimit { acoustic, acceleration, viscous };
constexpr std::size_t n_time_step_limits = 3;  ///< how many there are
/// The least of them.
TimeStepLimit deciding_limit(const Numerics& numerics, const TimeStepInput& input);

}  // namespace parapet::solver
