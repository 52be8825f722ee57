/// From a scene to the flow that is computed.
#pragma once

#include "parapet/flow/flow.hpp"
#include "parapet/solver/scene.hpp"

namespace parapet::solver {

/// Bed, back wall, barriers and solids of the scene and the released block on its lattice, with
/// what the numerics say of its start. The stem of barrier k is load
/// cell 2 k, its deflector 2 k + 1.
/// @pre scene_errors(scene) and numerics_errors(numerics) are empty
FlowSetup channel_setup(const Scene& scene, const Numerics& numerics, int threads);

}  // namespace parapet::solver
