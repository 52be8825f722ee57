// The bed below a place: the channel's, or the top of a further solid that lies on it.
#pragma once

#include "parapet/solver/scene.hpp"

namespace parapet::solver {

// Height of the highest surface below a place, normal to the channel's bed [m]; 0 is that bed. A
// barrier is no bed.
double bed_below(const Scene& scene, Vec2 place);

// Slope of the bed between two places along the channel, downhill positive [rad].
double bed_slope(const Scene& scene, double x_from, double x_to);

}  // namespace parapet::solver
