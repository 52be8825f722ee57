// How evenly the particles of a flow lie.
#pragma once

#include "flow.hpp"

namespace parapet::validation {

struct Evenness {
  double closest = 0.0;  // smallest distance of two particles over dx
  double spread = 0.0;   // standard deviation of sum W V away from the ends in z
};

// For flows without free surfaces.
Evenness evenness(const solver::Flow& flow);

}  // namespace parapet::validation
