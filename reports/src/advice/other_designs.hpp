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
///        than twice the residuals of a fit that predicts is marked, or than twice the measured
///        scatter where that is larger; where the rule knows its ties, these are marked
std::vector<Alternative> alternatives(const study::LoadedStudy& study,
                                      const records::EvaluationRecord& best,
                                      const std::vector<MetricResponse>& effects,
                                      const std::vector<Spread>& spread, const RuleFacts& rule);

}  // namespace parapet::reports
