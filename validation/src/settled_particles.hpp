// Particles without the order of a lattice but as evenly spread as shifting makes them: what a flow
// looks like inside after a while.
#pragma once

#include "parapet/flow/flow.hpp"

namespace parapet::validation {

// Moves the particles of the setup at random by up to `jitter` spacings and lets the shifting of
// the solver (Eq. 9, with the walls of the setup) spread them evenly. Only their places change.
void settle(solver::FlowSetup& setup, double jitter = 0.4, int steps = 100);

}  // namespace parapet::validation
