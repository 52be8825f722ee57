// What the cases share: walls, time loops, totals of a flow and orders of convergence.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "case.hpp"
#include "flow.hpp"

namespace parapet::validation {

// Adds an unbounded straight wall from a to b; the fluid lies on its left-hand side. It must reach
// at least two kernel supports (about 6 dx) past the fluid.
void add_wall(solver::FlowSetup& setup, solver::Vec2 a, solver::Vec2 b);

// A wall along x of a flow that is periodic over `length`: wall points for one period, seen in all.
// `upwards`: the fluid lies above it.
void add_periodic_wall(solver::FlowSetup& setup, double length, double z, bool upwards,
                       solver::Vec2 velocity = {});

class Balance;

// Steps until `time` [s]. Throws std::runtime_error with the reason when the flow fails.
// balance: is told of every step.
void advance(solver::Flow& flow, double time, const CaseRun& run, Balance* balance = nullptr);

// Steps until `end` and calls `sample` at the start and at every multiple of `interval` [s].
void advance_sampled(solver::Flow& flow, double end, double interval, const CaseRun& run,
                     const std::function<void(solver::Flow&)>& sample, Balance* balance = nullptr);

// Sums over the fluid, per metre width.
struct Totals {
  double mass = 0.0;              // [kg/m]
  solver::Vec2 momentum;          // [kg/s]
  double angular_momentum = 0.0;  // about the origin, anticlockwise in (x, z) [kg m/s]
  double kinetic = 0.0;           // [J/m]
  double potential = 0.0;         // in the flow's body forces [J/m]
  double elastic = 0.0;           // of the compressible fluid, sum m c^2/2 (rho/rho_0 - 1)^2 [J/m]
  double dissipation = 0.0;       // sum V eta g^2 with the present shear rates [W/m]
};
Totals totals(const solver::Flow& flow);

// Slope of log(error) against log(spacing), least squares.
double fitted_order(std::span<const double> spacings, std::span<const double> errors);

// sqrt(mean((a - b)^2)).
double rms_difference(std::span<const double> a, std::span<const double> b);

}  // namespace parapet::validation
