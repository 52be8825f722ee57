// Pictures of the flow in the Table 3 case, at the times that the source paper prints.
#pragma once

#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "particle_picture.hpp"

namespace parapet::validation {

// The frames of one row that are wanted.
class Frames {
 public:
  // Between frames [s]: every printed time is a whole number of them.
  static constexpr double interval = 0.005;

  Frames() = default;
  // @param times wanted [s]
  Frames(std::vector<double> times, const solver::Scene& scene);
  void take(const solver::Frame& frame);
  // Particles coloured by speed [m/s], with bed and barriers; the last frame where the run was
  // over.
  ParticlePanel at(double time) const;

 private:
  struct Timed {
    double time;  // [s]
    ParticlePanel panel;
  };
  std::vector<double> wanted_;
  std::vector<solver::Face> walls_;
  std::vector<Timed> kept_;
  Timed last_{-1.0, {}};
};

// The times at which a row is pictured [s].
std::vector<double> pictured_times(const std::string& row, const solver::Result& result);

// rows, results and frames go together: [n_rows].
void draw_table3_flows(CaseRun& run, const std::vector<designs::SweepRow>& rows,
                       const std::vector<solver::Result>& results,
                       const std::vector<Frames>& frames);

}  // namespace parapet::validation
