// Debris that a barrier throws back: what runs upstream between two barriers, or ahead of the
// first.
#pragma once

#include <optional>

#include "gauge_scene.hpp"
#include "parapet/flow/fluid.hpp"

namespace parapet::solver {

struct Backflow {
  double share = 0.0;           // of the released mass
  std::optional<double> speed;  // upstream [m/s]; nothing while too little flows back
};

// What moves upstream along the channel faster than rest_speed, between the line of the barrier
// before (or the back wall) and this barrier's. `speed` is the one that impact_mass_share of the
// released mass exceeds.
Backflow backflow(const GaugeScene& g, std::size_t barrier, const Fluid& fluid);

}  // namespace parapet::solver
