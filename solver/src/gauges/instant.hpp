// What is read at one instant, run.reading_time: how far the overflow reaches, and the slope of the
// ramp that the debris upstream of the first barrier has formed.
#pragma once

#include <optional>

#include "dead_zone.hpp"
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
  Ramp ramp;  // upstream of the first barrier
};

// Fluid is connected where particles are within the kernel's reach, 2h, of each other.
// @param reach 2h [m]
InstantReadings read_instant(const GaugeScene& g, const Fluid& fluid, double reach);

}  // namespace parapet::solver
