/// A run of a design beside what its study predicted of it.
#pragma once

#include <cstddef>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/confirmation.hpp"
#include "parapet/study/pick_rule.hpp"

namespace parapet::study {

/// The objectives in which a run is worse than the 95 % interval of its prediction. At the pick's
/// spacing the interval holds scatter and the surrogate's doubt, at another one the grid's too;
/// where that is not known, a run at another spacing is not held against the prediction. An
/// expression of metrics is taken at the pick's own variables.
std::vector<std::size_t> worse_than_predicted(const designs::StudySpec& study, const Pick& pick,
                                              const records::EvaluationRecord& run);

/// What the verdict needs of a line of confirmations.jsonl.
ConfirmationRun confirmation_run(const designs::StudySpec& study, const Pick& pick,
                                 const records::EvaluationRecord& run);

}  // namespace parapet::study
