#include "parapet/study/thread_count.hpp"

#include <algorithm>

namespace parapet::study {

int worthwhile_threads(const designs::CaseSpec& spec, int available) {
  // 2,400 particles on two threads took longer than on one wherever other programs ran as well:
  // some 50 loops a time step, each ending in a wait of the order of its own work
  constexpr double particles_per_thread = 2000.0;
  constexpr double most = 1e6;
  const double dx = spec.numerics.spacing;
  const double particles = spec.scene.reservoir_length * spec.scene.reservoir_height / (dx * dx);
  const auto useful = static_cast<int>(std::min(particles / particles_per_thread, most));
  return std::clamp(useful, 1, std::max(1, available));
}

int threads_each(std::size_t simulations, int places) {
  const auto n_places = static_cast<std::size_t>(std::max(1, places));
  const std::size_t at_once = std::clamp<std::size_t>(simulations, 1, n_places);
  return static_cast<int>(n_places / at_once);
}

}  // namespace parapet::study
