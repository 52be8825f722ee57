#include "channel_gauge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

double speed_squared(const Fluid& f, std::size_t i) {
  return f.u[i] * f.u[i] + f.w[i] * f.w[i];
}

}  // namespace

double front_position(const GaugeScene& g, const Fluid& f, double left_mass) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double ahead = left_mass;
  const double share = g.settings.front_mass_share * g.released_mass;
  if (ahead >= share) return g.scene->domain_length;
  if (f.n == 0) return 0.0;
  struct Parcel {
    double x, mass;
  };
  std::vector<Parcel> parcels;
  double collected = 0.0;  // mass
  const auto collect_from = [&](double x) {
    parcels.clear();
    collected = 0.0;
    for (std::size_t i = 0; i < at(f.n); ++i) {
      if (f.x[i] < x) continue;
      parcels.push_back({f.x[i], f.mass[i]});
      collected += f.mass[i];
    }
  };
  // mostly those near the foremost one are enough; beyond rounding, or else all are taken
  constexpr double near = 10.0, rounding = 1e-9;
  const double foremost = *std::max_element(f.x.begin(), f.x.begin() + f.n);
  collect_from(foremost - near * g.spacing);
  if (ahead + collected < (1.0 + rounding) * share) collect_from(-infinity);
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

}  // namespace parapet::solver
