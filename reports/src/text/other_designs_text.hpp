/// The recommended design beside others.
#pragma once

#include <optional>
#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// Empty without an improvement to tell of.
std::string improvement_section(const std::optional<Improvement>& improvement);

/// Empty without a recommended design, and where there is a front: that says it.
std::string alternatives_section(const Recommendation& recommendation);

}  // namespace parapet::reports
