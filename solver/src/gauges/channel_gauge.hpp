// Front, depth and kinetic energy: what is read along the channel at one instant.
#pragma once

#include "gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

// x that front_mass_share of the released mass is ahead of [m]; the outlet once that much has left.
double front_position(const GaugeScene& g, const Fluid& fluid, double left_mass);

// Mass over (density x length) in depth_window upstream of the gauge [m].
double flow_depth(const GaugeScene& g, const Fluid& fluid);

// The same upstream of another place along the channel [m].
double flow_depth_at(const GaugeScene& g, const Fluid& fluid, double x);

// Eq. 16 in energy_window either side of the gauge [J/m].
double window_kinetic_energy(const GaugeScene& g, const Fluid& fluid);
double total_kinetic_energy(const Fluid& fluid);  // [J/m]

}  // namespace parapet::solver
