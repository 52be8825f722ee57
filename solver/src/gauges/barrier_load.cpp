#include "barrier_load.hpp"

#include <algorithm>

namespace parapet::solver {

std::vector<BarrierLoad> LoadGauge::read(Flow& flow, double interval, double time) {
  std::vector<BarrierLoad> loads;
  const auto impulses = flow.take_impulses();
  for (std::size_t k = 0; k < impulses.size(); ++k) {
    const double per_time = interval > 0.0 ? 1.0 / interval : 0.0;
    const BarrierLoad load{per_time * impulses[k].force, per_time * impulses[k].moment};
    const double magnitude = norm(load.force);
    PeakLoad& peak = peaks_[k];
    if (magnitude > peak.force) {
      peak.force = magnitude;
      peak.force_time = time;
    }
    peak.moment = std::max(peak.moment, load.moment);
    loads.push_back(load);
  }
  return loads;
}

}  // namespace parapet::solver
