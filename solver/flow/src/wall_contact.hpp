// The last line of defence: a particle's path may not pass through a face. The wall pressure
// normally turns particles before; sharp edges in a fast flow are where it may come too late.
#pragma once

#include <span>

#include "parapet/flow/geometry.hpp"

namespace parapet::solver {

struct ParticleMotion {
  Vec2 before, after;  // [m]
  Vec2 velocity;       // [m/s]
};

struct WallContact {
  std::span<const Face> faces;
  double clearance;  // left between a stopped particle and the face [m]

  // Ends the path at the first face in its way and takes away the velocity into that face (a
  // perfectly plastic contact). Returns the face, or -1 when the path was free.
  int apply(ParticleMotion& motion, std::span<const int> candidates) const;
};

}  // namespace parapet::solver
