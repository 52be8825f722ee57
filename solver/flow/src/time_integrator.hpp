// The time integrations behind one interface.
#pragma once

#include <memory>
#include <optional>

#include "parapet/flow/flow.hpp"

namespace parapet::solver {

class TimeIntegrator {
 public:
  virtual ~TimeIntegrator() = default;
  // Largest multiple of h/(c_s + u_max) that is stable, and accurate enough, by default.
  virtual double default_acoustic_cfl() const = 0;
  // Share by which a step may exceed that, so that samples fall on their times.
  virtual double most_excess() const { return 0.0; }
  virtual bool explicit_viscosity() const = 0;
  // Moves positions, velocities and densities by dt. Pressure, volumes and rows are those of the
  // state before the step.
  virtual std::optional<Failure> advance(Flow& flow, double dt) = 0;
  // Whether every second step may do with the pairs that were picked for the one before.
  virtual bool keeps_pairs() const { return false; }
  // What it remembers from step to step.
  virtual IntegrationClock clock() const { return {}; }
  virtual void set_clock(const IntegrationClock& /*clock*/) {}
};

std::unique_ptr<TimeIntegrator> make_implicit_viscosity(int steps_per_solve);
std::unique_ptr<TimeIntegrator> make_rk4_explicit();
std::unique_ptr<TimeIntegrator> make_midpoint();  // for thin fluids

}  // namespace parapet::solver
