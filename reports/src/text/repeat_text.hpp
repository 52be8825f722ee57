#pragma once

#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// What one more run of the recommended design would give, and what that rests on.
std::string repeat_section(const Recommendation& advice);

}  // namespace parapet::reports
