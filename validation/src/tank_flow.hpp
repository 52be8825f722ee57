// A tank of fluid at rest, with or without a barrier in it: how much it moves and what it weighs
// on.
#pragma once

#include <string>
#include <vector>

#include "case.hpp"
#include "parapet/flow/flow.hpp"
#include "particle_picture.hpp"

namespace parapet::validation::tank_flows {

struct Tank {
  const char* key;
  const char* name;
  solver::Material material;
  double slope;    // of the bed [rad]
  double length;   // of the bed, between walls normal to it [m]
  double surface;  // height of the surface above the upper corner of the bed, in the world [m]
  bool barrier;
  double spacing;  // [m]
  double time;     // [s]
  solver::Integrator integrator = solver::Integrator::implicit_viscosity;
  double shifting = 1.0;  // share of the shifting velocity
  // Of the barrier: bare ones stay under water.
  bool bare = false;
  double foot = 0.22, thickness = 0.015;  // [m]
};

struct TankRun {
  std::vector<double> time, largest, rms;              // speeds over sqrt(gH) [%]
  std::vector<double> pressure_rms, pressure_largest;  // errors over rho g H [%]
  double drift = 0.0;    // of the centre of mass in the second half, over H [%]
  int inside = 0;        // particles inside walls
  double plates = 0.0;   // largest error of the force on a plate over the sum on all [%]
  double barrier = 0.0;  // the same for the whole barrier [%]
  double mass_change = 0.0, momentum_error = 0.0;
  double lasted = 0.0;  // time until the flow failed [s]
  std::string failure;
  ParticlePanel speed, pressure;
  std::vector<solver::Face> walls;
};

TankRun computed(const Tank& tank, const CaseRun& run);

}  // namespace parapet::validation::tank_flows
