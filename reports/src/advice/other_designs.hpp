/// The recommended design beside others: where the search began, and what would do nearly as well.
#pragma once

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// Against the best starting design; empty without a usable one.
std::optional<Improvement> improvement(const study::LoadedStudy& study,
                                       const records::EvaluationRecord& best);

/// The best feasible designs that are apart from the best and from each other: by 5 % of some
/// variable's range or by a choice.
/// @param effects of variable_effects(): with one objective, an alternative that is worse by less
///        than twice the scatter about a fit that predicts is marked
std::vector<Alternative> alternatives(const study::LoadedStudy& study,
                                      const records::EvaluationRecord& best,
                                      const std::vector<MetricResponse>& effects);

}  // namespace parapet::reports
