// Which material can still change a metric.
#pragma once

#include "gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

// Where an open channel's gauge ends, as a line normal to the bed: no metric sees what has passed.
BarrierLine end_of_gauge(const GaugeScene& g);

// Kinetic energy of what is upstream of the last barrier's line, or of the end of an open channel's
// gauge [J/m]: only this can pass a line, load a barrier or move a front; what has passed runs
// away. Left out are its fastest parcels, a share `droplets` of the released mass: single droplets
// decide no metric.
double live_energy(const GaugeScene& g, const Fluid& fluid, double droplets);

// Whether arrival_mass_share of the released mass are upstream of the line and, each at its present
// speed, would reach it within a time [s].
bool may_still_arrive(const GaugeScene& g, const BarrierLine& line, const Fluid& fluid,
                      double time);

}  // namespace parapet::solver
