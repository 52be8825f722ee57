#pragma once

#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// The trade-off between several objectives; empty without a front.
std::string front_section(const Recommendation& recommendation);

}  // namespace parapet::reports
