#include "barrier_load.hpp"

#include <algorithm>
#include <utility>

namespace parapet::solver {
namespace {

constexpr double peak_window = 0.005;  // [s]

BarrierLoad mean(const BarrierImpulse& impulse, double time) {
  const double per_time = time > 0.0 ? 1.0 / time : 0.0;
  return {per_time * impulse.force, per_time * impulse.moment};
}

void add(BarrierImpulse& sum, const BarrierImpulse& impulse) {
  sum.force = sum.force + impulse.force;
  sum.moment += impulse.moment;
}

}  // namespace

void LoadGauge::observe(std::vector<BarrierImpulse> impulses, double time_step, double time) {
  for (std::size_t k = 0; k < impulses.size(); ++k) add(interval_[k], impulses[k]);
  interval_time_ += time_step;
  window_time_ += time_step;
  window_.push_back({time_step, std::move(impulses)});
  constexpr double enough = peak_window * (1.0 - 1e-9);
  while (window_time_ - window_.front().time >= enough) {
    window_time_ -= window_.front().time;
    window_.pop_front();
  }
  if (window_time_ >= enough) update_peaks(time);
}

void LoadGauge::update_peaks(double time) {
  for (std::size_t k = 0; k < peaks_.size(); ++k) {
    BarrierImpulse sum;
    double covered = 0.0;  // added anew each time: a running sum would drift
    for (const Step& step : window_) {
      add(sum, step.impulses[k]);
      covered += step.time;
    }
    const BarrierLoad load = mean(sum, covered);
    PeakLoad& peak = peaks_[k];
    if (norm(load.force) > peak.force) {
      peak.force = norm(load.force);
      peak.force_time = time;
    }
    peak.moment = std::max(peak.moment, load.moment);
  }
}

std::vector<BarrierLoad> LoadGauge::read() {
  std::vector<BarrierLoad> loads;
  for (BarrierImpulse& impulse : interval_) {
    loads.push_back(mean(impulse, interval_time_));
    impulse = {};
  }
  interval_time_ = 0.0;
  return loads;
}

}  // namespace parapet::solver
