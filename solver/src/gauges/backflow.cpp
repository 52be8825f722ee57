#include "backflow.hpp"

#include <algorithm>
#include <vector>

#include "parapet/flow/index.hpp"

namespace parapet::solver {

Backflow backflow(const GaugeScene& g, std::size_t barrier, const Fluid& f) {
  const double rest_speed = g.speed(g.settings.rest_speed_ratio);
  struct Parcel {
    double speed, mass;
  };
  std::vector<Parcel> parcels;
  double mass = 0.0;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    if (f.u[i] >= -rest_speed) continue;
    const Vec2 p{f.x[i], f.z[i]};
    if (g.lines[barrier].offset(p) >= 0.0) continue;
    if (barrier > 0 && g.lines[barrier - 1].offset(p) < 0.0) continue;
    parcels.push_back({-f.u[i], f.mass[i]});
    mass += f.mass[i];
  }
  Backflow back{.share = mass / g.released_mass, .speed = {}};
  const double wanted = g.settings.impact_mass_share * g.released_mass;
  if (mass < wanted) return back;
  std::sort(parcels.begin(), parcels.end(), [](const Parcel& a, const Parcel& b) {
    return a.speed > b.speed || (a.speed == b.speed && a.mass > b.mass);
  });
  double faster = 0.0;
  for (const Parcel& p : parcels) {
    faster += p.mass;
    back.speed = p.speed;
    if (faster >= wanted) break;
  }
  return back;
}

}  // namespace parapet::solver
