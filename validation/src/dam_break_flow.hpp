// One simulated dam break with the gauges and sensors of the experiment.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "lobovsky.hpp"
#include "particle_picture.hpp"
#include "water.hpp"

namespace parapet::validation {

struct DamBreak {
  double depth = 0.3;  // H [m]
  double spacing = 0.01;
  double alpha = 0.01;         // of the grid's viscosity; 0: that of water
  double sound_factor = 20.0;  // sound speed over sqrt(g H)
  solver::WallSlip slip = solver::WallSlip::free_slip;
  unsigned seed = 0;
  double end = 8.0;                   // t*
  std::vector<double> pictures = {};  // t*
};

// All against t* = t sqrt(g/H), lengths over H, pressures over rho g H, forces over rho g H^2.
struct DamBreakRecord {
  std::array<Series, 4> depth, pressure;
  Series front;                     // from the gate
  Series impulse;                   // of the water on the far wall since the start, horizontally
  Series head;                      // (depth + u^2/2g) of the stream at the last gauge
  double arrival = 0.0;             // of the pressure at the lowest sensor
  double loss_before_impact = 0.0;  // not viscous, share of the available energy, at t* = 2.2
  double loss_at_end = 0.0, viscous_at_end = 0.0;
  std::vector<ParticlePanel> speed, pressures;
  std::unique_ptr<solver::Flow> flow;  // at the end
  std::unique_ptr<Balance> balance;

  // Largest mean over `window` [t*] of a sensor within one t* after the arrival.
  double peak(std::size_t sensor, double window) const;
  // The same of the force on the far wall.
  double peak_force(double window) const;
};

DamBreakRecord simulated(const DamBreak& dam, const Lobovsky& measured, const CaseRun& run);

// Rough CPU seconds.
double cost_of(const DamBreak& dam);

}  // namespace parapet::validation
