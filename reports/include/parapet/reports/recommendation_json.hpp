/// recommendation.json
#pragma once

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// Format "parapet-recommendation/1".
designs::Json recommendation_json(const Recommendation& recommendation);

}  // namespace parapet::reports
