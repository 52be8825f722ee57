/// The pieces that a recommendation is put together from.
#pragma once

#include <string>

#include "study_log.hpp"

namespace parapet::reports {

/// A fit explains designs left out of it roughly from here on, and can be trusted from there.
constexpr double rough_r2 = 0.3;
constexpr double trusted_r2 = 0.7;

/// What each variable does to each metric that the study asks about; shape in recommendation.cpp.
designs::Json effects_json(const StudyLog& log);

/// The recommendation for a reader, from its JSON.
std::string recommendation_text(const designs::Json& json);

}  // namespace parapet::reports
