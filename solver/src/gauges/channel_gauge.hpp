// Front, depth, kinetic energy and dead zone: what is read along the channel at one instant.
#pragma once

#include "gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

// x that 0.5 % of the released mass is ahead of [m]; the outlet once that much has left.
double front_position(const GaugeScene& g, const Fluid& fluid, double left_mass);

// Mass over (density x length) in the 40 mm upstream of the gauge [m].
double flow_depth(const GaugeScene& g, const Fluid& fluid);

// Eq. 16 in the window 0.05 m either side of the gauge [J/m].
double window_kinetic_energy(const GaugeScene& g, const Fluid& fluid);
double total_kinetic_energy(const Fluid& fluid);  // [J/m]

// Length along the bed, from the foot upstream, over which without a gap more material is at rest
// (slower than 0.1 m/s) than the bed alone can hold: deeper than 1.25 tau_y/(rho g sin a) [m].
double dead_zone_length(const GaugeScene& g, const Fluid& fluid);

}  // namespace parapet::solver
