// Mass on either side of the barriers' lines (Eq. 17), run-up and arrival.
#pragma once

#include "gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

// Mass upstream of a line over the mass released; material that has left the domain is downstream.
double retention_efficiency(const GaugeScene& g, const BarrierLine& line, const Fluid& fluid,
                            double left_mass);

// Height above the bed that 0.1 % of the released mass exceeds within 40 mm upstream of the line;
// 0 while there is less than that [m].
double run_up_height(const GaugeScene& g, const BarrierLine& line, const Fluid& fluid);

// Mass within 20 mm upstream of the line over the mass released.
double mass_share_at_line(const GaugeScene& g, const BarrierLine& line, const Fluid& fluid);

}  // namespace parapet::solver
