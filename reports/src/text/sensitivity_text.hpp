#pragma once

#include <optional>
#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// Which variables matter; empty when it is not known.
std::string sensitivity_section(const Recommendation& advice);

}  // namespace parapet::reports
