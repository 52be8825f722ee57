// What the numerics of a run were like, and what of it is outside the limits.
#pragma once

#include <vector>

#include "parapet/flow/fluid.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::solver {

// Share of the mass that has come off the fluid.
double spray_share(const Fluid& fluid);

// |rho/rho_0 - 1| that this share of the mass exceeds.
double density_error(const Fluid& fluid, double reference_density, double mass_share);

constexpr double density_mass_share = 0.01;  // of what counts as more than droplets

// Coefficient of variation of the particles' masses, weighted by nothing.
double mass_spread(const Fluid& fluid);

// The largest rise of a mechanical energy above its lowest value before.
class EnergyGain {
 public:
  void observe(double energy);
  double largest() const { return largest_; }  // [J/m]

 private:
  bool begun_ = false;
  double lowest_ = 0.0, largest_ = 0.0;
};

// What is outside the limits, in the order of the quality's members.
// @param unfinished the run was cut off while metrics could still change
std::vector<Warning> warnings_of(const Quality& quality, bool unfinished, double stop_time);

}  // namespace parapet::solver
