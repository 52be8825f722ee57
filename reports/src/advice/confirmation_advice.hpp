#pragma once

#include "parapet/reports/recommendation.hpp"
#include "parapet/study/pick.hpp"

namespace parapet::reports {

/// What the runs in confirmations.jsonl say of the pick.
/// @param confirmed with a pick
Confirmation confirmation_of(const study::LoadedStudy& study,
                             const study::ConfirmedPick& confirmed);

}  // namespace parapet::reports
