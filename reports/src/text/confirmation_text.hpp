#pragma once

#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// How sure the recommended design is; empty without one.
std::string confirmation_section(const Recommendation& recommendation);

}  // namespace parapet::reports
