/// What a recommendation does not tell, in sentences.
#pragma once

#include "study_log.hpp"

namespace parapet::reports {

/// @param best recommended design, or nullptr
/// @param variables its variables as the recommendation lists them (with "at_bound")
designs::Json caveats_json(const StudyLog& log, const LoggedDesign* best,
                           const designs::Json& variables);

}  // namespace parapet::reports
