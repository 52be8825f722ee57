#include "live_material.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

double energy_of_kilogramme(const Fluid& f, std::size_t i) {
  return 0.5 * (f.u[i] * f.u[i] + f.w[i] * f.w[i]);  // [J/kg]
}

}  // namespace

BarrierLine end_of_gauge(const GaugeScene& g) {
  const double window = std::max(g.length(g.settings.energy_window_ratio),
                                 0.5 * g.length(g.settings.front_base_ratio));
  return {{g.gauge_x + window, 0.0}, {1.0, 0.0}};
}

double live_energy(const GaugeScene& g, const Fluid& f, double droplets) {
  const BarrierLine last = g.lines.empty() ? end_of_gauge(g) : g.lines.back();
  struct Parcel {
    double energy, mass;
  };
  std::vector<Parcel> live;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    if (last.offset({f.x[i], f.z[i]}) < 0.0) {
      live.push_back({energy_of_kilogramme(f, i), f.mass[i]});
    }
  }
  std::sort(live.begin(), live.end(), [](const Parcel& a, const Parcel& b) {
    return a.energy > b.energy || (a.energy == b.energy && a.mass > b.mass);
  });
  double mass = 0.0, energy = 0.0;
  for (const Parcel& p : live) {
    mass += p.mass;
    if (mass > droplets * g.released_mass) energy += p.mass * p.energy;
  }
  return energy;
}

bool may_still_arrive(const GaugeScene& g, const BarrierLine& line, const Fluid& f, double time) {
  double mass = 0.0;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    const double distance = -line.offset({f.x[i], f.z[i]});
    if (distance > 0.0 && std::sqrt(2.0 * energy_of_kilogramme(f, i)) * time >= distance)
      mass += f.mass[i];
  }
  return mass >= g.settings.arrival_mass_share * g.released_mass;
}

}  // namespace parapet::solver
