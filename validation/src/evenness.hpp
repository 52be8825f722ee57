// How evenly the particles of a flow lie.
#pragma once

#include "parapet/flow/flow.hpp"

namespace parapet::validation {

struct Evenness {
  double closest = 0.0;  // smallest distance of two particles over dx
  // Standard deviations away from the ends in z: of sum W V, and of sum W dx^2, which depends on
  // the places alone.
  double spread = 0.0, places = 0.0;
};

// For flows without free surfaces.
Evenness evenness(const solver::Flow& flow);

}  // namespace parapet::validation
