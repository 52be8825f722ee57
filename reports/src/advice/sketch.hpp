#pragma once

#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"

namespace parapet::reports {

/// The barriers of a design in four lines of characters, upstream on the left, not to scale; empty
/// where there is no barrier, more than three, or an impossible scene.
std::vector<std::string> sketch_of(const designs::StudySpec& study, const designs::Design& design);

}  // namespace parapet::reports
