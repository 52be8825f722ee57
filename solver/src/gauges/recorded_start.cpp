#include "recorded_start.hpp"

#include <algorithm>
#include <cmath>

#include "channel_gauge.hpp"
#include "dead_zone.hpp"
#include "quality.hpp"

namespace parapet::solver {

GaugeSight::GaugeSight(const GaugeScene& g, double reach) : nearest_x_(g.gauge_x) {
  // what moves is looked at no farther upstream of a line than this
  const GaugeSettings& s = g.settings;
  const double gauges = 1.2 * g.length(std::max({s.energy_window_ratio, s.depth_window_ratio,
                                                 s.run_up_window_ratio, s.arrival_window_ratio}));
  constexpr double wall_cells = 3.0;  // a wall is looked up in cells of the rows' reach
  margin_ = std::max({gauges, ramp_reach(g), wall_cells * reach});
  for (const Barrier& barrier : g.scene->barriers) {
    for (const Vec2 corner : barrier_outline(*g.scene, barrier)) {
      nearest_x_ = std::min(nearest_x_, corner.x);
    }
  }
  lines_ = g.lines;
  if (!g.lines.empty()) lines_.push_back(g.edges.front());
}

bool GaugeSight::clear(double x, double z) const {
  if (x >= nearest_x_ - margin_) return false;
  return std::all_of(lines_.begin(), lines_.end(), [&](const BarrierLine& line) {
    return line.offset({x, z}) < -margin_ && line.offset({x, 0.0}) < -margin_;
  });
}

bool RecordedStart::unseen(const GaugeSight& sight) const {
  return std::all_of(reaches.begin(), reaches.end(),
                     [&](const Reach& reach) { return sight.clear(reach.x, reach.z); });
}

RecordedStart::Sample channel_sample(const GaugeScene& g, const Flow& flow) {
  const Fluid& f = flow.fluid();
  double potential = 0.0, fastest = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    potential -= f.mass[i] * dot(flow.setup().gravity, {f.x[i], f.z[i]});
    fastest = std::max(fastest, f.u[i] * f.u[i] + f.w[i] * f.w[i]);
  }
  return {.time = flow.time(),
          .kinetic_energy = total_kinetic_energy(f),
          .potential_energy = potential,
          .front_x = front_position(g, f, flow.left_mass()),
          .max_speed = std::sqrt(fastest),
          .left_mass = flow.left_mass(),
          .inside_walls = flow.particles_inside_walls(),
          .spray_share = spray_share(f),
          .density_error = density_error(f, g.scene->material.density, density_mass_share)};
}

}  // namespace parapet::solver
