/// recommendation.md
#pragma once

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// The recommendation for a reader, as Markdown.
std::string recommendation_text(const Recommendation& recommendation);

}  // namespace parapet::reports
