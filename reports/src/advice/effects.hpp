#pragma once

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// A fit explains designs left out of it roughly from here on, and can be trusted from there.
constexpr double rough_r2 = 0.3;
constexpr double trusted_r2 = 0.7;

/// What each variable does to each metric of the objectives, then of the constraints. Empty where a
/// variable is a choice or does not exist in every design.
std::vector<MetricResponse> variable_effects(const study::LoadedStudy& study);

}  // namespace parapet::reports
