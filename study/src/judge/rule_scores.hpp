/// What each rule minimises.
#pragma once

#include <string>

#include "parapet/study/pick.hpp"
#include "rank_draws.hpp"

namespace parapet::study {

/// The place of an objective that an option names, by its name or its metric.
/// @throws designs::InputError naming the option and the study's objectives
std::size_t objective_index(const designs::StudySpec& study, const std::string& name,
                            const char* option);

/// The scores of a rule, resolved to one that is not automatic. `study` must outlive them.
Scores scores_of(const LoadedStudy& study, const PickRule& rule, RuleKind kind);

}  // namespace parapet::study
