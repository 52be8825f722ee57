/// Straight walls for flows that are no channels.
#pragma once

#include "parapet/flow/flow.hpp"

namespace parapet::solver {

/// Adds an unbounded straight wall from a to b; the fluid lies on its left-hand side. It must reach
/// at least two kernel supports (about 6 dx) past the fluid, or end at another wall.
void add_wall(FlowSetup& setup, Vec2 a, Vec2 b);

/// A wall along x at height z of a flow that is periodic over `length` [m]: wall points for one
/// period, seen in all. With `upwards` the fluid lies above it. The wall itself moves with
/// `velocity` [m/s].
/// @pre setup.numerics.spacing is set
void add_periodic_wall(FlowSetup& setup, double length, double z, bool upwards, Vec2 velocity = {});

/// Makes all walls load cell 0, so that take_impulses() gives all that the walls do. Call it when
/// the setup has all its walls.
void measure_all_walls(FlowSetup& setup);

}  // namespace parapet::solver
