// Figures of the Table 3 case, after those of the source paper.
#pragma once

#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "particle_picture.hpp"

namespace parapet::validation {

struct TimedPanel {
  double time;  // [s]
  ParticlePanel panel;
};

// Particles of a frame coloured by speed [m/s], with bed and barriers.
TimedPanel timed_panel(const solver::Frame& frame, const solver::Scene& scene);

// rows, results and panels go together: [n_rows].
void draw_table3(CaseRun& run, const std::vector<designs::SweepRow>& rows,
                 const std::vector<solver::Result>& results,
                 const std::vector<std::vector<TimedPanel>>& panels);

}  // namespace parapet::validation
