/// The trade-off between a study's objectives.
#pragma once

#include "parapet/reports/recommendation.hpp"
#include "parapet/study/pick.hpp"

namespace parapet::reports {

std::vector<FrontDesign> front_designs(const designs::StudySpec& study,
                                       const study::Choice& choice);

/// For each objective in which another design of the front is better than this one: the nearest of
/// these and the best. Empty for a design that is not on the front.
std::vector<WayOut> ways_out(const study::Choice& choice, const records::EvaluationRecord& from);

/// The search's progress; empty for one objective or where pareto.json is not known.
std::optional<Progress> search_progress(const study::LoadedStudy& study);

}  // namespace parapet::reports
