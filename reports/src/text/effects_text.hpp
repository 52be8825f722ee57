#pragma once

#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// What each variable does; empty without fits.
std::string effects_section(const Recommendation& advice);

}  // namespace parapet::reports
