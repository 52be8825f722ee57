#include "instant.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bed.hpp"
#include "connected.hpp"
#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

struct Part {
  std::vector<Vec2> places;
  std::vector<double> masses;
};

template <typename Wanted>
Part part_of(const Fluid& f, Wanted wanted) {
  Part part;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    const Vec2 p{f.x[i], f.z[i]};
    if (!wanted(p)) continue;
    part.places.push_back(p);
    part.masses.push_back(f.mass[i]);
  }
  return part;
}

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

// Slope of the least squares line through the tops of equal columns.
void read_ramp(const GaugeScene& g, const Fluid& f, double reach, InstantReadings& readings) {
  const GaugeSettings& s = g.settings;
  const double height = g.scene->barriers.front().height;
  const double from = g.edge.foot.x - s.ramp_far_ratio * height;
  const double to = g.edge.foot.x - s.ramp_near_ratio * height;
  const int columns = std::max(
      2, static_cast<int>(std::floor((to - from) / (s.ramp_column_ratio * height) + 1e-9)));
  const double width = (to - from) / columns;
  readings.ramp_too_coarse = width < fewest_across_window * g.spacing * (1.0 - 1e-9);
  if (readings.ramp_too_coarse) return;
  const BarrierLine& line = g.lines.front();
  const Part upstream = part_of(f, [&](Vec2 p) { return line.offset(p) < 0.0; });
  std::vector<double> top(at(columns), -1.0);
  for (const std::size_t i : main_body(upstream.places, upstream.masses, reach)) {
    const Vec2 p = upstream.places[i];
    const auto column = static_cast<int>(std::floor((p.x - from) / width));
    if (column >= 0 && column < columns) top[at(column)] = std::max(top[at(column)], p.z);
  }
  double sx = 0.0, sz = 0.0, sxx = 0.0, sxz = 0.0;
  for (int k = 0; k < columns; ++k) {
    if (top[at(k)] < 0.0) return;  // the debris does not reach over the whole window
    const double x = (k + 0.5) * width;
    sx += x;
    sz += top[at(k)];
    sxx += x * x;
    sxz += x * top[at(k)];
  }
  readings.ramp_angle = std::atan((columns * sxz - sx * sz) / (columns * sxx - sx * sx));
}

}  // namespace

InstantReadings read_instant(const GaugeScene& g, const Fluid& fluid, double reach) {
  InstantReadings readings;
  if (g.lines.empty()) return readings;
  readings.tongue = read_tongue(g, fluid, reach);
  read_ramp(g, fluid, reach, readings);
  return readings;
}

double ramp_reach(const GaugeScene& g) {
  if (g.lines.empty()) return 0.0;
  return g.settings.ramp_far_ratio * g.scene->barriers.front().height;
}

}  // namespace parapet::solver
