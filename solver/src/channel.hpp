// From a scene to the flow that is computed: bed, back wall, barriers and the released block.
#pragma once

#include "flow.hpp"
#include "parapet/solver/scene.hpp"

namespace parapet::solver {

FlowSetup channel_setup(const Scene& scene, const Numerics& numerics, int threads);

// A block of fluid [x0, x0 + length] x [z0, z0 + height] on a regular lattice whose cells fill it
// exactly; density rho_0, at rest.
std::vector<InitialParticle> lattice_block(double x0, double z0, double length, double height,
                                           double spacing, double density);

}  // namespace parapet::solver
