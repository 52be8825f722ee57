/// Where the wall time of a run went, and what it did in that time (RunOptions::profile).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace parapet::solver {

/// One stage of the time loop. Times are exclusive: a stage inside another one is not counted
/// twice.
struct StageTime {
  std::string name;
  double seconds = 0.0;    ///< of wall time, in the calling thread
  std::int64_t calls = 0;  ///< how often it was entered
  std::int64_t pairs = 0;  ///< directed pairs within the kernel's reach that it visited; 0 for
                           ///< stages that are no neighbour sums
};

/// Seconds differ between repeats of a run; everything else is the same.
struct Profile {
  std::vector<StageTime> stages;        ///< in the order of the method; together the whole run
  std::int64_t steps_acoustic = 0;      ///< steps whose length the sound speed decided
  std::int64_t steps_acceleration = 0;  ///< ... the largest acceleration
  std::int64_t steps_viscous = 0;       ///< ... explicit viscosity
  /// Mean share by which steps were shorter than the stable one to meet sample times; negative
  /// where they were longer.
  double step_shortening = 0.0;
  double fluid_neighbors = 0.0;          ///< mean of fluid neighbours within the kernel's reach
  double wall_neighbors = 0.0;           ///< mean of wall points within the kernel's reach
  double slots_per_pair = 0.0;           ///< row slots over such pairs: what skin and padding add
  double steps_after_last_change = 0.0;  ///< share of the steps after a metric last changed; one
                                         ///< that creeps, by more than settled.retention_change
  double rest_share = 0.0;  ///< share of the particle-steps that were spent on material slower than
                            ///< 1/100 of the speed of a fall from the reservoir's height
  double seconds() const;   ///< sum of the stages
};

}  // namespace parapet::solver
