#pragma once

#include <string>

#include "parapet/study/pick.hpp"

namespace parapet::reports {

/// The rule that made a choice, for a reader.
std::string rule_words(const study::LoadedStudy& study, const study::PickRule& rule,
                       const study::Choice& choice);

}  // namespace parapet::reports
