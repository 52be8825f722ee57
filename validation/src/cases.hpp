// The cases, one file each; the file tells what is measured and where the answer comes from.
#pragma once

#include "case.hpp"

namespace parapet::validation {

void plane_flows(CaseRun& run);
void tanks(CaseRun& run);
void uniform_flow(CaseRun& run);
void slump(CaseRun& run);
void pond(CaseRun& run);
void grid_convergence(CaseRun& run);
void noise(CaseRun& run);
void smoothness(CaseRun& run);

}  // namespace parapet::validation
