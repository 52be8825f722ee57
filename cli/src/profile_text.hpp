/// What a run's time went into, as a table for people.
#pragma once

#include <string>

#include "parapet/solver/result.hpp"

namespace parapet::cli {

/// The stages with their seconds, share and calls, for neighbour sums also the cost of a directed
/// pair; then what decided the time step, and what the neighbour rows and the viscous solve did.
std::string profile_text(const solver::Profile& profile, const solver::RunStatistics& statistics);

}  // namespace parapet::cli
