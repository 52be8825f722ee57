#pragma once

#include <string>
#include <utility>
#include <vector>

#include "parapet/study/loaded_study.hpp"

namespace parapet::reports {

/// Metric key and what it means, for as many barriers as the study's designs have.
std::vector<std::pair<std::string, std::string>> metric_definitions(
    const study::LoadedStudy& study);

}  // namespace parapet::reports
