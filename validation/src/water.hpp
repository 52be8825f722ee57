// Water released from a column beside a wall, and what is measured in it: depths, front, pressure
// at a wall. Shared by the dam breaks.
#pragma once

#include <functional>
#include <vector>

#include "balance.hpp"
#include "case.hpp"
#include "parapet/flow/flow.hpp"

namespace parapet::validation {

// A column of water in the left corner of a tank, released at once at t = 0.
struct WaterTank {
  double column_length = 0.0;  // [m]
  double column_depth = 0.0;   // [m]
  double length = 0.0;         // [m]
  double wall_height = 0.0;    // [m]
  double spacing = 0.0;        // [m]
  double sound_speed = 0.0;    // [m/s]
  double viscosity = 1e-3;     // [Pa s]
  solver::WallSlip slip = solver::WallSlip::free_slip;
  double shifting = 1.0;
  unsigned seed = 0;  // of offsets of up to a tenth of the spacing in the first lattice; 0: none
};

constexpr double water_density = 997.0;  // [kg/m3]
constexpr double gravity = 9.81;         // [m/s2]

// Dynamic viscosity that stands for the artificial viscosity alpha of SPH: alpha rho c h/8 in two
// dimensions [Pa s].
double viscosity_of_alpha(const WaterTank& tank, double alpha);

// Potential energy above the state at rest in the whole tank [J/m].
double available_energy(const WaterTank& tank);

// Walls are load cells: number 1 is the right wall, number 0 the rest.
solver::FlowSetup water_setup(const WaterTank& tank);

// A quantity against time.
struct Series {
  std::vector<double> t, value;
  void add(double time, double v) {
    t.push_back(time);
    value.push_back(v);
  }
  // Linear between the samples, constant past the ends.
  double at(double time) const;
  // First time at which the value reaches `level`; not a number if it never does.
  double first_reaches(double level) const;
  // Mean over [time - half, time + half], the samples joined by straight lines.
  double mean_around(double time, double half) const;
  double integral(double from, double to) const;
};

// Depth of the water that stands on the floor at x: mass in a strip of this width over density and
// width, from the floor up to the first vertical gap of at least `gap` [m]. Particles count as
// squares with the share of them that lies in the strip.
double depth_at(const solver::Flow& flow, double x, double width, double gap);

// Where the water ends: ahead of it lies this share of the mass [m].
double front_position(const solver::Flow& flow, double share);

// Pressure of the fluid at a point of a wall with the weights by which the wall boundary takes the
// fluid's pressure (kernel and hydrostatic head, never negative); 0 while dry [Pa].
double pressure_at_wall(const solver::Flow& flow, double x, double z);

// Steps until `end` and shows every state to `each`, with pressures up to date.
void follow(solver::Flow& flow, double end, const CaseRun& run, Balance& balance,
            const std::function<void(solver::Flow&)>& each);

}  // namespace parapet::validation
