/// A sweep's results beside the published figures, for the terminal.
#pragma once

#include <string>
#include <vector>

#include "parapet/records/sweep_row.hpp"

namespace parapet::reports {

/// An aligned table for a terminal, with the published figure beside the computed one wherever
/// there is one, a legend, and a count of the published ranges met.
/// @param spacing particle spacing dx [m]
std::string sweep_table_text(const std::vector<records::SweepRowResult>& rows, double spacing);

}  // namespace parapet::reports
