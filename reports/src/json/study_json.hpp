#pragma once

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// What was studied: variables, objectives, constraints, scenarios, spacings, numbers, method.
designs::Json to_json(const StudyFacts& study);

}  // namespace parapet::reports
