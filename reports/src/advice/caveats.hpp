#pragma once

#include <string>
#include <vector>

#include "parapet/reports/design_report.hpp"
#include "parapet/study/loaded_study.hpp"

namespace parapet::reports {

/// What a recommendation does not tell, one sentence or two each.
/// @param best the recommended design; null when there is none
std::vector<std::string> caveats(const study::LoadedStudy& study, const DesignReport* best);

}  // namespace parapet::reports
