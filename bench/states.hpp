// The states that are measured: the flow of row H10-D45 of Table 3 on its way, the same with finer
// particles, and a plain block.
#pragma once

#include "parapet/flow/channel.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::bench {

// One barrier of 100 mm with a deflector of 65 mm at 45 degrees: designs/single_barrier.json.
solver::Scene h10_d45();

solver::Numerics numerics_of(double spacing);

// H10-D45 after `time` [s] of flow at this spacing [m], on the way for the same spacing or to be
// refined: every particle is replaced by refinement^2 particles that take velocity and density from
// the flow around them (none nearer to a wall than a tenth of their spacing), and up to 200 steps
// are taken until the viscous solve hardly notices any more: at 1 mm it needs 65 iterations a step
// at first, 46 after 200 steps.
solver::FlowSetup developed_flow(double spacing, double time, int refinement);

// n x n particles of 5 mm without walls, every one moved at random by up to 0.2 dx; 100 x 100 have
// 20.1 neighbours in the mean.
solver::FlowSetup box(int n);

// One step after another; throws when one fails.
void advance(solver::Flow& flow, int steps);
void advance_to(solver::Flow& flow, double time);

}  // namespace parapet::bench
