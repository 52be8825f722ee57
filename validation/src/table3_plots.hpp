// Curves of the Table 3 case, after those of the source paper.
#pragma once

#include <vector>

#include "case.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::validation {

// rows and results go together: [n_rows].
void draw_table3(CaseRun& run, const std::vector<designs::SweepRow>& rows,
                 const std::vector<solver::Result>& results);

}  // namespace parapet::validation
