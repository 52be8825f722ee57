#include "barrier_load.hpp"

#include <algorithm>

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

void LoadGauge::observe(Flow& flow) {
  const auto impulses = flow.take_impulses();
  for (std::size_t k = 0; k < impulses.size(); ++k) {
    add(window_[k], impulses[k]);
    add(interval_[k], impulses[k]);
  }
  window_time_ += flow.last_time_step();
  interval_time_ += flow.last_time_step();
  if (window_time_ >= peak_window * (1.0 - 1e-9)) close_window(flow.time());
}

void LoadGauge::close_window(double time) {
  for (std::size_t k = 0; k < window_.size(); ++k) {
    const BarrierLoad load = mean(window_[k], window_time_);
    PeakLoad& peak = peaks_[k];
    if (norm(load.force) > peak.force) {
      peak.force = norm(load.force);
      peak.force_time = time;
    }
    peak.moment = std::max(peak.moment, load.moment);
    window_[k] = {};
  }
  window_time_ = 0.0;
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
