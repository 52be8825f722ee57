// The design load of barriers by the momentum of the flow around them, against the load gauge.
#pragma once

#include "case.hpp"

namespace parapet::validation {

void add_load_by_momentum(CaseRun& run);

}  // namespace parapet::validation
