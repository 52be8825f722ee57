#pragma once

#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// The title, the design and the reasons in a few lines.
std::string opening_section(const Recommendation& recommendation);

}  // namespace parapet::reports
