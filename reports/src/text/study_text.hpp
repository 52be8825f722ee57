#pragma once

#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// What was studied.
std::string study_section(const StudyFacts& study);

}  // namespace parapet::reports
