// Force and overturning moment on the barriers.
#pragma once

#include <vector>

#include "../flow.hpp"

namespace parapet::solver {

// Mean force and moment of one sampling interval, per metre width.
struct BarrierLoad {
  Vec2 force;           // [N/m]
  double moment = 0.0;  // about the foot, positive downstream [N m/m]
};

// Largest loads so far.
struct PeakLoad {
  double force = 0.0;        // magnitude [N/m]
  double force_time = -1.0;  // [s], negative while there was none
  double moment = 0.0;       // [N m/m]
};

class LoadGauge {
 public:
  explicit LoadGauge(std::size_t n_barriers) : peaks_(n_barriers) {}
  // Loads averaged over the interval that ends at `time`.
  std::vector<BarrierLoad> read(Flow& flow, double interval, double time);
  const std::vector<PeakLoad>& peaks() const { return peaks_; }

 private:
  std::vector<PeakLoad> peaks_;
};

}  // namespace parapet::solver
