#include "instant.hpp"

#include <algorithm>
#include <vector>

#include "bed.hpp"
#include "connected.hpp"
#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

std::optional<InstantReadings::Tongue> read_tongue(const GaugeScene& g, const Fluid& f,
                                                   double reach) {
  const BarrierLine& line = g.lines.front();
  const Part beyond = part_of(f, [&](Vec2 p) { return line.offset(p) >= 0.0; });
  if (beyond.places.empty()) return std::nullopt;
  InstantReadings::Tongue tongue{-1e300, -1e300, false};
  for (const Vec2 p : beyond.places) tongue.farthest_x = std::max(tongue.farthest_x, p.x);
  const std::vector<std::size_t> body = main_body(beyond.places, beyond.masses, reach);
  for (const std::size_t i : body) tongue.tip_x = std::max(tongue.tip_x, beyond.places[i].x);
  for (const std::size_t i : body) {
    const Vec2 p = beyond.places[i];
    if (p.x < tongue.tip_x - g.length(g.settings.approach_height_ratio)) continue;
    const double above = p.z - bed_below(*g.scene, p);
    tongue.landed = tongue.landed || above < g.length(g.settings.landing_height_ratio);
  }
  return tongue;
}

}  // namespace

InstantReadings read_instant(const GaugeScene& g, const Fluid& fluid, double reach) {
  InstantReadings readings;
  if (g.lines.empty()) return readings;
  readings.tongue = read_tongue(g, fluid, reach);
  readings.ramp = ramp(g, 0, fluid, reach);
  return readings;
}

}  // namespace parapet::solver
