#pragma once

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

StudyFacts study_facts(const study::LoadedStudy& study);

}  // namespace parapet::reports
