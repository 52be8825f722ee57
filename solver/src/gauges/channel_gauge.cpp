#include "channel_gauge.hpp"

#include <algorithm>
#include <cmath>

#include "bed.hpp"
#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

double speed_squared(const Fluid& f, std::size_t i) {
  return f.u[i] * f.u[i] + f.w[i] * f.w[i];
}

// On the bed alone a layer of tau_y/(rho g sin a) can stay at rest; what is clearly deeper rests
// because the barrier holds it.
double least_dead_depth(const GaugeScene& g, double slope) {
  const Scene& scene = *g.scene;
  const double drive = scene.material.density * scene.gravity * std::sin(std::abs(slope));
  const double layer = drive > 0.0 ? scene.material.yield_stress / drive : 0.0;
  return std::clamp(g.settings.dead_zone_depth_factor * layer,
                    g.length(g.settings.dead_zone_least_depth_ratio),
                    g.length(g.settings.dead_zone_most_depth_ratio));
}

}  // namespace

double front_position(const GaugeScene& g, const Fluid& f, double left_mass) {
  double ahead = left_mass;
  const double share = g.settings.front_mass_share * g.released_mass;
  if (ahead >= share) return g.scene->domain_length;
  struct Parcel {
    double x, mass;
  };
  std::vector<Parcel> parcels(at(f.n));
  for (std::size_t i = 0; i < parcels.size(); ++i) parcels[i] = {f.x[i], f.mass[i]};
  const auto farther = [](const Parcel& a, const Parcel& b) {
    return a.x > b.x || (a.x == b.x && a.mass > b.mass);
  };
  // only the foremost few are ever looked at
  std::size_t sorted = 0;
  for (std::size_t i = 0; i < parcels.size(); ++i) {
    if (i == sorted) {
      sorted = std::min(parcels.size(), 2 * sorted + 32);
      std::partial_sort(parcels.begin(), parcels.begin() + static_cast<std::ptrdiff_t>(sorted),
                        parcels.end(), farther);
    }
    ahead += parcels[i].mass;
    if (ahead >= share) return parcels[i].x;
  }
  return 0.0;
}

double flow_depth(const GaugeScene& g, const Fluid& f) {
  return flow_depth_at(g, f, g.gauge_x);
}

double flow_depth_at(const GaugeScene& g, const Fluid& f, double x) {
  const double window = g.length(g.settings.depth_window_ratio);
  double mass = 0.0;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    if (f.x[i] <= x && f.x[i] > x - window) mass += f.mass[i];
  }
  return mass / (g.scene->material.density * window);
}

double window_kinetic_energy(const GaugeScene& g, const Fluid& f) {
  const double window = g.length(g.settings.energy_window_ratio);
  double energy = 0.0;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    if (std::abs(f.x[i] - g.gauge_x) <= window) {
      energy += 0.5 * f.mass[i] * speed_squared(f, i);
    }
  }
  return energy;
}

double total_kinetic_energy(const Fluid& f) {
  double energy = 0.0;
  for (std::size_t i = 0; i < at(f.n); ++i) energy += 0.5 * f.mass[i] * speed_squared(f, i);
  return energy;
}

double dead_zone_length(const GaugeScene& g, const Fluid& f) {
  if (g.lines.empty()) return 0.0;
  const double foot = g.lines.front().foot.x;
  // columns parallel to the stem, so that the first one is as deep as the others
  const double lean = g.lines.front().downstream.z / g.lines.front().downstream.x;
  const double bin_length = g.length(g.settings.dead_zone_window_ratio);
  const double rest_speed = g.speed(g.settings.rest_speed_ratio);
  const auto bins = at(static_cast<int>(std::ceil(foot / bin_length)));
  std::vector<double> at_rest(bins, 0.0);
  for (std::size_t i = 0; i < at(f.n); ++i) {
    const double upstream = foot - (f.x[i] + lean * f.z[i]);
    if (upstream <= 0.0 || speed_squared(f, i) >= rest_speed * rest_speed) continue;
    at_rest[std::min(bins - 1, at(static_cast<int>(upstream / bin_length)))] += f.mass[i];
  }
  double length = 0.0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const double to = foot - static_cast<double>(bin) * bin_length;
    const double slope = bed_slope(*g.scene, std::max(0.0, to - bin_length), to);
    const double enough = g.scene->material.density * bin_length * least_dead_depth(g, slope);
    if (at_rest[bin] < enough) return length + bin_length * at_rest[bin] / enough;
    length += bin_length;
  }
  return length;
}

}  // namespace parapet::solver
