// The cases, one file each; the file tells what is measured and where the answer comes from.
#pragma once

#include "case.hpp"

namespace parapet::validation {

void operators(CaseRun& run);
void slip_planes(CaseRun& run);
void plane_flows(CaseRun& run);
void uniform_flow(CaseRun& run);
void frictional_layer(CaseRun& run);
void tanks(CaseRun& run);
void conservation(CaseRun& run);
void energy_gain(CaseRun& run);
void taylor_green(CaseRun& run);
void oscillating_drop(CaseRun& run);
void rotating_patch(CaseRun& run);
void slump(CaseRun& run);
void pond(CaseRun& run);
void dam_break(CaseRun& run);
void water_column(CaseRun& run);
void ballistic(CaseRun& run);
void table3(CaseRun& run);
void table3_as_published(CaseRun& run);
void grid_convergence(CaseRun& run);
void noise(CaseRun& run);
void resolution(CaseRun& run);
void smoothness(CaseRun& run);

}  // namespace parapet::validation
