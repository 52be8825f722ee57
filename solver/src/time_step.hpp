// The largest stable time step: acoustic, body force, and viscous when viscosity is explicit.
#pragma once

#include <cstddef>

#include "parapet/solver/numerics.hpp"

namespace parapet::solver {

struct TimeStepInput {
  double smoothing_length;  // [m]
  double max_speed;         // [m/s]
  double max_acceleration;  // [m/s2]
  double max_viscosity;     // [Pa s]; 0 when viscosity is implicit
  double density;           // [kg/m3]
  double acoustic_cfl;
};

// Which of the three decides.
enum class TimeStepLimit { acoustic, acceleration, viscous };
constexpr std::size_t n_time_step_limits = 3;
TimeStepLimit deciding_limit(const Numerics& numerics, const TimeStepInput& input);

// min(cfl h/(c_s + u), cfl sqrt(h/a), cfl h^2 rho/eta) [s].
double stable_time_step(const Numerics& numerics, const TimeStepInput& input);

}  // namespace parapet::solver
