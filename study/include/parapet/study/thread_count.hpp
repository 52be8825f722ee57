/// How many threads are worthwhile for a simulation.
#pragma once

#include <cstddef>

#include "parapet/designs/case_spec.hpp"

namespace parapet::study {

/// At most `available` (>= 1), and fewer for a scene of few particles, where threads would wait
/// for each other longer than they work. No result depends on it.
int worthwhile_threads(const designs::CaseSpec& spec, int available);

/// Threads for each of so many simulations that share the places of a service: more than one only
/// where there are more places than simulations.
int threads_each(std::size_t simulations, int places);

}  // namespace parapet::study
