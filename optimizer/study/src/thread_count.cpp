#include "parapet/study/thread_count.hpp"

#include <algorithm>

namespace parapet::study {

int worthwhile_threads(const designs::CaseSpec& spec, int available) {
  constexpr double particles_per_thread = 300.0;
  constexpr double most = 1e6;
  const double dx = spec.numerics.spacing;
  const double particles = spec.scene.reservoir_length * spec.scene.reservoir_height / (dx * dx);
  const auto useful = static_cast<int>(std::min(particles / particles_per_thread, most));
  return std::clamp(useful, 1, std::max(1, available));
}

}  // namespace parapet::study
