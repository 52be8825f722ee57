#include "barrier_load.hpp"

#include <algorithm>
#include <utility>

namespace parapet::solver {
namespace {

BarrierLoad mean(const BarrierImpulse& impulse, double time) {
  const double per_time = time > 0.0 ? 1.0 / time : 0.0;
  return {per_time * impulse.force, per_time * impulse.moment};
}

void add(BarrierImpulse& sum, const BarrierImpulse& impulse) {
  sum.force = sum.force + impulse.force;
  sum.moment += impulse.moment;
}

}  // namespace

void LoadGauge::observe(std::vector<BarrierImpulse> impulses, double time_step, double time,
                        const std::vector<Vec2>& strips) {
  for (std::size_t cell = 0; cell < impulses.size(); ++cell) {
    add(interval_[cell], impulses[cell]);
    Vec2& whole = whole_[cell / cells_per_barrier];
    whole = whole + impulses[cell].force;
  }
  interval_time_ += time_step;
  covered_ += time_step;
  strips_.resize(std::max(strips_.size(), strips.size()));
  steps_.push_back({time_step, std::move(impulses), strips_});
  for (std::size_t k = 0; k < strips.size(); ++k) strips_[k] = strips_[k] + strips[k];
  const double enough = windows_[design_window] * (1.0 - 1e-9);
  while (covered_ - steps_.front().time >= enough) {
    covered_ -= steps_.front().time;
    steps_.pop_front();
  }
  for (std::size_t k = 0; k < loads_.size(); ++k) update_peaks(k, time);
}

// From the latest step backwards, added anew each time: a running sum would drift.
void LoadGauge::update_peaks(std::size_t barrier, double time) {
  BarrierLoads& loads = loads_[barrier];
  BarrierImpulse stem, deflector;
  double covered = 0.0;
  int window = 0;
  for (auto step = steps_.rbegin(); step != steps_.rend() && window < load_windows; ++step) {
    add(stem, step->impulses[cells_per_barrier * barrier]);
    add(deflector, step->impulses[cells_per_barrier * barrier + 1]);
    covered += step->time;
    for (; window < load_windows &&
           covered >= windows_[static_cast<std::size_t>(window)] * (1.0 - 1e-9);
         ++window) {
      BarrierImpulse both = stem;
      add(both, deflector);
      const BarrierLoad load = mean(both, covered);
      PeakLoad& peak = loads.peak[static_cast<std::size_t>(window)];
      const bool larger = norm(load.force) > peak.force;
      if (larger) {
        peak.force = norm(load.force);
        peak.force_time = time;
      }
      peak.moment = std::max(peak.moment, load.moment);
      if (window != design_window) continue;
      if (larger) {
        loads.design = load;
        keep_strips(loads, *step, covered);
      }
      loads.stem = std::max(loads.stem, norm(mean(stem, covered).force));
      loads.deflector = std::max(loads.deflector, norm(mean(deflector, covered).force));
    }
  }
}

// The means since the beginning of a step.
void LoadGauge::keep_strips(BarrierLoads& loads, const Step& first, double covered) const {
  loads.design_time = covered;
  loads.design_strips = strips_;
  for (std::size_t k = 0; k < strips_.size(); ++k) {
    const Vec2 before = k < first.strips_before.size() ? first.strips_before[k] : Vec2{};
    loads.design_strips[k] = (1.0 / covered) * (strips_[k] - before);
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
