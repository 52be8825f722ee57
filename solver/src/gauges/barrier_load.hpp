// Force and overturning moment on the barriers.
#pragma once

#include <deque>
#include <vector>

#include "parapet/flow/flow.hpp"

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

// Peaks are those of the running mean over 5 ms, whatever the interval of the series.
class LoadGauge {
 public:
  explicit LoadGauge(std::size_t n_barriers) : interval_(n_barriers), peaks_(n_barriers) {}
  // After every time step: its impulses on the barriers [n_barriers], its length and its end [s].
  void observe(std::vector<BarrierImpulse> impulses, double time_step, double time);
  // Mean loads since the last reading.
  std::vector<BarrierLoad> read();
  const std::vector<PeakLoad>& peaks() const { return peaks_; }

 private:
  struct Step {
    double time;                           // its length [s]
    std::vector<BarrierImpulse> impulses;  // [n_barriers]
  };
  void update_peaks(double time);

  std::deque<Step> window_;  // the latest steps, just enough to fill 5 ms
  double window_time_ = 0.0;
  std::vector<BarrierImpulse> interval_;
  double interval_time_ = 0.0;  // [s]
  std::vector<PeakLoad> peaks_;
};

}  // namespace parapet::solver
