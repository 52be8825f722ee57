// Mass on either side of the barriers' lines (Eq. 17), run-up and arrival.
#pragma once

#include "gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

// Mass upstream of a line over the mass released; material that has left the domain is downstream.
double retention_efficiency(const GaugeScene& g, const BarrierLine& line, const Fluid& fluid,
                            double left_mass);

// Height above the bed that run_up_mass_share of the released mass exceeds within run_up_window
// upstream of the line; 0 while there is less than that [m].
double run_up_height(const GaugeScene& g, const BarrierLine& line, const Fluid& fluid);

// Mass within arrival_window upstream of the line over the mass released.
double mass_share_at_line(const GaugeScene& g, const BarrierLine& line, const Fluid& fluid);

}  // namespace parapet::solver
