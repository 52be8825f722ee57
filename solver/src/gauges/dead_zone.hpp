// The dead zone: what rests upstream of a barrier because the barrier holds it.
#pragma once

#include <optional>

#include "gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

struct DeadZone {
  double length = 0.0;  // along the bed, from the foot upstream [m]
  double area = 0.0;    // of what is at rest over that length [m2]
};

// In columns of dead_zone_window parallel to the stem, from the barrier's foot up to the line of
// the barrier before it, or to the back wall: without a gap more material is at rest (slower than
// rest_speed) than the bed alone can hold, deeper than dead_zone_depth_factor tau_y/(rho g sin a),
// a the slope of the bed there. A last column that is not deep enough counts by its share.
DeadZone dead_zone(const GaugeScene& g, std::size_t barrier, const Fluid& fluid);

// Slope of the free surface upstream of a barrier, in bed axes, rising downstream.
struct Ramp {
  std::optional<double> angle;  // [rad]; nothing where the debris does not reach over all columns
  bool too_coarse = false;      // fewer than four particles across a column
};

// Least squares line through the highest particles of the main body in columns of ramp_column, from
// ramp_near to ramp_far stem heights upstream of the last edge.
// @param reach particles within it of each other are connected: the kernel's, 2h [m]
Ramp ramp(const GaugeScene& g, std::size_t barrier, const Fluid& fluid, double reach);

// How far upstream of the first barrier's last edge the ramp is looked at [m]; 0 without a barrier.
double ramp_reach(const GaugeScene& g);

}  // namespace parapet::solver
