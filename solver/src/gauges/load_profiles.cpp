// How the design loads are spread over the height of stems and the length of deflectors.
#include <algorithm>

#include "recorder.hpp"

namespace parapet::solver {

double LoadProfile::normal_force() const {
  double force = 0.0;
  for (std::size_t k = 0; k < pressure.size(); ++k) force += pressure[k] * (edge[k + 1] - edge[k]);
  return force;
}

std::vector<LoadProfile> Recorder::load_profiles(const Flow& flow) const {
  std::vector<LoadProfile> profiles;
  const double spacing = flow.setup().numerics.spacing;
  std::size_t first = 0;  // strip of the load axis
  for (std::size_t cell = 0; cell < flow.setup().load_axes.size(); ++cell) {
    const LoadAxis& axis = flow.setup().load_axes[cell];
    const auto n = static_cast<std::size_t>(axis.strips(spacing));
    const std::size_t barrier = cell / cells_per_barrier;
    const BarrierLoads& loads = loads_.loads()[barrier];
    if (n == 0) continue;  // no deflector
    LoadProfile profile;
    profile.barrier = static_cast<int>(barrier) + 1;
    profile.deflector = cell % cells_per_barrier == 1;
    profile.window_end = loads.peak[design_window].force_time;
    profile.window = loads.design_time;
    // clockwise from the axis: downstream of a stem that leads up, upwards of a plate that leads
    // upstream
    profile.normal = {axis.direction.z, -axis.direction.x};
    for (std::size_t k = 0; k < n; ++k) {
      profile.edge.push_back(static_cast<double>(k) * spacing);
    }
    profile.edge.push_back(axis.length);
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 force =
          first + k < loads.design_strips.size() ? loads.design_strips[first + k] : Vec2{};
      profile.pressure.push_back(dot(force, profile.normal) /
                                 (profile.edge[k + 1] - profile.edge[k]));
    }
    first += n;
    profiles.push_back(std::move(profile));
  }
  return profiles;
}

}  // namespace parapet::solver
