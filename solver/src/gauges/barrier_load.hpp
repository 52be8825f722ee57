// Force and overturning moment on the barriers.
#pragma once

#include <array>
#include <deque>
#include <vector>

#include "parapet/flow/flow.hpp"

namespace parapet::solver {

// Mean force and moment of one sampling interval, per metre width.
struct BarrierLoad {
  Vec2 force;           // [N/m]
  double moment = 0.0;  // about the foot, positive downstream [N m/m]
};

// Largest running means so far, over one window.
struct PeakLoad {
  double force = 0.0;        // magnitude [N/m]
  double force_time = -1.0;  // end of that window [s]; negative while there was none
  double moment = 0.0;       // [N m/m]
};

// The windows of the running means, in rising order of their lengths.
enum LoadWindow { slam_window, short_window, design_window, load_windows };

// The loads on one barrier. Stem and deflector are two load cells: what acts on either of them
// has its own largest means, at its own time.
struct BarrierLoads {
  std::array<PeakLoad, load_windows> peak;  // of both together
  BarrierLoad design;                       // when its mean over the design window was largest
  double stem = 0.0, deflector = 0.0;       // largest means over the design window [N/m]
  // When it was largest: mean forces on the strips of all load axes, and over what time.
  std::vector<Vec2> design_strips;  // [n_strips] [N/m]
  double design_time = 0.0;         // [s]
};

// How a scene's load cells are numbered: see channel_setup.
constexpr std::size_t cells_per_barrier = 2;

class LoadGauge {
 public:
  // @param windows of the running means, rising [s]
  LoadGauge(std::size_t n_barriers, std::array<double, load_windows> windows)
      : windows_(windows),
        interval_(n_barriers * cells_per_barrier),
        whole_(n_barriers),
        loads_(n_barriers) {}
  // After every time step: its impulses on the load cells [n_barriers x cells_per_barrier], its
  // length and its end [s].
  // @param strips likewise on the strips of the load axes, or empty where nothing acts
  void observe(std::vector<BarrierImpulse> impulses, double time_step, double time,
               const std::vector<Vec2>& strips = {});
  // Mean loads on the load cells since the last reading.
  std::vector<BarrierLoad> read();
  const std::vector<BarrierLoads>& loads() const { return loads_; }
  // Impulse on a barrier since the release [N s/m].
  Vec2 impulse(std::size_t barrier) const { return whole_[barrier]; }

 private:
  struct Step {
    double time;                           // its length [s]
    std::vector<BarrierImpulse> impulses;  // of the load cells
    std::vector<Vec2> strips_before;       // impulses on the strips since the release, before it
  };
  void update_peaks(std::size_t barrier, double time);
  void keep_strips(BarrierLoads& loads, const Step& first, double covered) const;

  std::array<double, load_windows> windows_;
  std::deque<Step> steps_;  // the latest, just enough to fill the longest window
  double covered_ = 0.0;    // by them [s]
  std::vector<BarrierImpulse> interval_;
  double interval_time_ = 0.0;        // [s]
  std::vector<Vec2> whole_, strips_;  // since the release
  std::vector<BarrierLoads> loads_;
};

}  // namespace parapet::solver
