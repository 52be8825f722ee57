#include "parapet/flow/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::solver {

double stable_time_step(const Numerics& numerics, const TimeStepInput& in) {
  const double h = in.smoothing_length;
  double dt = in.acoustic_cfl * h / (numerics.sound_speed + in.max_speed);
  if (in.max_acceleration > 0.0) {
    dt = std::min(dt, numerics.cfl_force * std::sqrt(h / in.max_acceleration));
  }
  if (in.max_viscosity > 0.0) {
    dt = std::min(dt, numerics.cfl_viscous * h * h * in.density / in.max_viscosity);
  }
  return dt;
}

double dividing_step(double longest, double stable, double most_excess) {
  constexpr double rounding = 1e-9;
  const double many = std::max(1.0, std::ceil(longest / stable - rounding)), fewer = many - 1.0;
  return longest / (longest <= (1.0 + most_excess) * stable * fewer ? fewer : many);
}

TimeStepLimit deciding_limit(const Numerics& numerics, const TimeStepInput& in) {
  TimeStepInput fewer = in;
  fewer.max_acceleration = fewer.max_viscosity = 0.0;
  const double dt = stable_time_step(numerics, in);
  if (dt == stable_time_step(numerics, fewer)) return TimeStepLimit::acoustic;
  fewer.max_acceleration = in.max_acceleration;
  if (dt == stable_time_step(numerics, fewer)) return TimeStepLimit::acceleration;
  return TimeStepLimit::viscous;
}

}  // namespace parapet::solver
