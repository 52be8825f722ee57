/// How many threads a simulation is worth.
#pragma once

#include "parapet/designs/case_spec.hpp"

namespace parapet::study {

/// At most `available` (>= 1), and fewer for a scene of few particles, where threads would wait
/// for each other longer than they work. No result depends on it.
int worthwhile_threads(const designs::CaseSpec& spec, int available);

}  // namespace parapet::study
