// What is read at one instant, run.reading_time: how far the overflow reaches, and the slope of the
// ramp that the debris upstream of the barrier has formed.
#pragma once

#include <optional>

#include "gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

struct InstantReadings {
  // The body of fluid beyond the first barrier's line; absent when there is none.
  struct Tongue {
    double tip_x;       // largest x of it [m]
    double farthest_x;  // of any particle beyond the line [m]
    bool landed;        // within approach_height of its tip it is on the bed
  };
  std::optional<Tongue> tongue;
  std::optional<double> ramp_angle;  // in bed axes, rising downstream [rad]
  bool ramp_too_coarse = false;      // fewer than four particles across one of its columns
};

// Fluid is connected where particles are within the kernel's reach, 2h, of each other.
// @param reach 2h [m]
InstantReadings read_instant(const GaugeScene& g, const Fluid& fluid, double reach);

// How far upstream of the last edge's x the ramp is looked at [m]; 0 without a barrier.
double ramp_reach(const GaugeScene& g);

}  // namespace parapet::solver
