#include "retention.hpp"

#include <algorithm>

namespace parapet::solver {
double retention_efficiency(const GaugeScene& g, const BarrierLine& line, const Fluid& f,
                            double left_mass) {
  // what has passed, not what is upstream: 1 to the bit while nothing has
  double passed = left_mass;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    if (line.offset({f.x[i], f.z[i]}) >= 0.0) passed += f.mass[i];
  }
  return 1.0 - passed / g.released_mass;
}

double run_up_height(const GaugeScene& g, const BarrierLine& line, const Fluid& f) {
  const double window = g.length(g.settings.run_up_window_ratio);
  struct Parcel {
    double z, mass;
  };
  std::vector<Parcel> parcels;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const double s = line.offset({f.x[i], f.z[i]});
    if (s < 0.0 && s > -window) parcels.push_back({f.z[i], f.mass[i]});
  }
  std::sort(parcels.begin(), parcels.end(), [](const Parcel& a, const Parcel& b) {
    return a.z > b.z || (a.z == b.z && a.mass > b.mass);
  });
  double mass = 0.0;
  for (const Parcel& p : parcels) {
    mass += p.mass;
    if (mass >= g.settings.run_up_mass_share * g.released_mass) return p.z;
  }
  return 0.0;
}

double mass_share_at_line(const GaugeScene& g, const BarrierLine& line, const Fluid& f) {
  const double window = g.length(g.settings.arrival_window_ratio);
  double mass = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const double s = line.offset({f.x[i], f.z[i]});
    if (s < 0.0 && s > -window) mass += f.mass[i];
  }
  return mass / g.released_mass;
}

}  // namespace parapet::solver
