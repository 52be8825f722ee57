#include "dead_zone.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bed.hpp"
#include "connected.hpp"
#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

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

DeadZone dead_zone(const GaugeScene& g, std::size_t barrier, const Fluid& f) {
  const BarrierLine& line = g.lines[barrier];
  const double foot = line.foot.x, start = barrier > 0 ? g.lines[barrier - 1].foot.x : 0.0;
  // columns parallel to the stem, so that the first one is as deep as the others
  const double lean = line.downstream.z / line.downstream.x;
  const double bin_length = g.length(g.settings.dead_zone_window_ratio);
  const double rest_speed = g.speed(g.settings.rest_speed_ratio);
  const auto bins = at(static_cast<int>(std::ceil((foot - start) / bin_length)));
  std::vector<double> at_rest(bins, 0.0);
  for (std::size_t i = 0; i < at(f.n); ++i) {
    const double upstream = foot - (f.x[i] + lean * f.z[i]);
    if (upstream <= 0.0 || f.u[i] * f.u[i] + f.w[i] * f.w[i] >= rest_speed * rest_speed) continue;
    if (barrier > 0 && g.lines[barrier - 1].offset({f.x[i], f.z[i]}) < 0.0) continue;
    at_rest[std::min(bins - 1, at(static_cast<int>(upstream / bin_length)))] += f.mass[i];
  }
  const double density = g.scene->material.density;
  DeadZone zone;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const double to = foot - static_cast<double>(bin) * bin_length;
    const double slope = bed_slope(*g.scene, std::max(0.0, to - bin_length), to);
    const double enough = density * bin_length * least_dead_depth(g, slope);
    const double share = std::min(1.0, at_rest[bin] / enough);
    zone.length += bin_length * share;
    zone.area += at_rest[bin] / density * share;
    if (at_rest[bin] < enough) break;
  }
  return zone;
}

Ramp ramp(const GaugeScene& g, std::size_t barrier, const Fluid& f, double reach) {
  const GaugeSettings& s = g.settings;
  const double height = g.scene->barriers[barrier].height, edge = g.edges[barrier].foot.x;
  const double from = edge - s.ramp_far_ratio * height;
  const double to = edge - s.ramp_near_ratio * height;
  const int columns = std::max(
      2, static_cast<int>(std::floor((to - from) / (s.ramp_column_ratio * height) + 1e-9)));
  const double width = (to - from) / columns;
  if (width < fewest_across_window * g.spacing * (1.0 - 1e-9))
    return {.angle = {}, .too_coarse = true};
  const Part upstream = part_of(f, [&](Vec2 p) {
    return g.lines[barrier].offset(p) < 0.0 &&
           (barrier == 0 || g.lines[barrier - 1].offset(p) >= 0.0);
  });
  std::vector<double> top(at(columns), -1.0);
  for (const std::size_t i : main_body(upstream.places, upstream.masses, reach)) {
    const Vec2 p = upstream.places[i];
    const auto column = static_cast<int>(std::floor((p.x - from) / width));
    if (column >= 0 && column < columns) top[at(column)] = std::max(top[at(column)], p.z);
  }
  double sx = 0.0, sz = 0.0, sxx = 0.0, sxz = 0.0;
  for (int k = 0; k < columns; ++k) {
    if (top[at(k)] < 0.0) return {};  // the debris does not reach over the whole window
    const double x = (k + 0.5) * width;
    sx += x;
    sz += top[at(k)];
    sxx += x * x;
    sxz += x * top[at(k)];
  }
  return {.angle = std::atan((columns * sxz - sx * sz) / (columns * sxx - sx * sx))};
}

double ramp_reach(const GaugeScene& g) {
  if (g.lines.empty()) return 0.0;
  return g.settings.ramp_far_ratio * g.scene->barriers.front().height;
}

}  // namespace parapet::solver
