/// What came of one run, for a reader who wants to know before any list of metrics.
#pragma once

#include <string>

#include "parapet/solver/result.hpp"

namespace parapet::reports {

/// Lines of words and units, each beginning with two blanks and ending with a line feed: how the
/// flow ended, what was held back, how far the overflow flew, what each barrier bore, warnings. An
/// uncertainty (95 %) stands beside its value; a value that the run does not have gives its reason.
/// Metrics that are not in the result have no line: an open channel has front and depth instead of
/// retention and loads.
std::string run_summary(const solver::Result& result);

}  // namespace parapet::reports
