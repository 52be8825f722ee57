// A uniform layer whose yield stress grows with the pressure, c + p tan(phi), on slopes around the
// one at which it stops: rho g h sin a = c + rho g h cos a tan(phi). Below the cut-off rate g_c the
// fluid of the solver creeps, so that "stops" needs a criterion: the layer is no faster than twice
// the exact creep of the regularised fluid at that slope.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "flow_tools.hpp"
#include "parapet/flow/flow.hpp"

namespace parapet::validation {
namespace {

using solver::Flow;
using solver::Fluid;
using solver::Material;
using solver::Scheme;

constexpr double depth = 0.04;    // [m]
constexpr double gravity = 9.81;  // [m/s2]
constexpr double sound_speed = 10.0;
constexpr double end_time = 2.0;  // by which the flow is steady [s]; rho h^2/K is 1.8 s
constexpr double degree = std::numbers::pi / 180.0;
constexpr double offsets[] = {-2.0, -1.0, -0.5, 0.5, 1.0, 2.0};  // from that slope [deg]

struct Layer {
  const char* key;
  const char* name;
  double cohesion;   // [Pa]
  double angle_deg;  // phi
};
constexpr Layer layers[] = {{"frictional", "no cohesion, 20 deg", 0.0, 20.0},
                            {"cohesive", "45 Pa, 15 deg", 45.0, 15.0}};

Material material_of(const Layer& layer) {
  Material m;
  m.yield_stress = layer.cohesion;
  m.consistency = 1.0;
  m.flow_index = 1.0;
  m.friction_angle = layer.angle_deg * degree;
  return m;
}

// The root of sin a = c/(rho g h) + cos a tan(phi): sin(a - phi) = c cos(phi)/(rho g h).
double stopping_slope(const Material& m) {
  return m.friction_angle +
         std::asin(m.yield_stress * std::cos(m.friction_angle) / (m.density * gravity * depth));
}

// Mean speed of the regularised fluid, exactly: its rate at a depth y below the surface is
// (tau - tau_y)/K above the cut-off and tau/eta_c below, integrated twice.
double exact_speed(const Material& m, double slope) {
  constexpr int steps = 4000;
  double speed = 0.0;
  for (int k = 0; k < steps; ++k) {
    const double y = depth * (k + 0.5) / steps, weight = m.density * gravity * y;
    const double yield = m.yield_stress + weight * std::cos(slope) * std::tan(m.friction_angle);
    const double flowing = (weight * std::sin(slope) - yield) / m.consistency;
    const double stiff = yield / m.cutoff_shear_rate + m.consistency;
    const double rate = flowing > m.cutoff_shear_rate ? flowing : weight * std::sin(slope) / stiff;
    speed += rate * y / steps;  // the mean of u is the integral of rate y/h over the depth
  }
  return speed;
}

struct Way {
  const char* key;
  const char* name;
  Scheme scheme;
  int across;     // particles over the depth
  double offset;  // largest, of each particle at random, as a share of the spacing
  bool judged;    // else the slope alone is shown
};
constexpr Way ways[] = {{"corrected", "corrected", Scheme::corrected, 24, 0.0, true},
                        {"published", "as published", Scheme::as_published, 24, 0.0, true},
                        {"coarse", "corrected, 12 across", Scheme::corrected, 12, 0.0, false},
                        {"disordered", "as published, particles offset by 0.3 dx",
                         Scheme::as_published, 24, 0.3, false}};

struct Tilted {
  const Layer* layer;
  const Way* way;
  double slope;  // [rad]
};

double mean_speed(const Tilted& tilted, const CaseRun& run) {
  solver::FlowSetup setup;
  const double dx = depth / tilted.way->across, length = 12.0 * dx;
  setup.numerics.spacing = dx;
  setup.numerics.sound_speed = sound_speed;
  setup.numerics.cg_tolerance = 1e-3;
  setup.numerics.scheme = tilted.way->scheme;
  setup.material = material_of(*tilted.layer);
  setup.gravity = {gravity * std::sin(tilted.slope), -gravity * std::cos(tilted.slope)};
  setup.periodic_length = length;
  add_periodic_wall(setup, length, 0.0, true);
  const double rho = setup.material.density;
  setup.particles = solver::lattice_block(0.0, 0.0, length, depth, dx, rho);
  std::minstd_rand random(1);
  const auto offset = [&] {
    return tilted.way->offset * dx * (2.0 * static_cast<double>(random()) / random.max() - 1.0);
  };
  for (solver::InitialParticle& p : setup.particles) {
    p.x += offset();
    p.z += offset();
    p.density -= rho * setup.gravity.z * (depth - p.z) / (sound_speed * sound_speed);
  }
  Flow flow(std::move(setup));
  advance(flow, end_time, run);
  const solver::Totals sum = totals(flow);
  return sum.momentum.x / sum.mass;
}

// Where the speed passes the limit, by the logarithm of the speed between the slopes [deg].
double crossing(const std::vector<double>& speeds, double limit) {
  for (std::size_t k = 1; k < speeds.size(); ++k) {
    if (!(speeds[k - 1] <= limit && speeds[k] > limit)) continue;
    const double share = std::log(limit / speeds[k - 1]) / std::log(speeds[k] / speeds[k - 1]);
    return offsets[k - 1] + share * (offsets[k] - offsets[k - 1]);
  }
  return std::nan("");
}

}  // namespace

void frictional_layer(CaseRun& run) {
  std::vector<Tilted> list;
  for (const Way& way : ways) {
    for (const Layer& layer : layers) {
      for (const double offset : offsets) {
        list.push_back({&layer, &way, stopping_slope(material_of(layer)) + offset * degree});
      }
    }
  }
  std::vector<double> speeds(list.size());
  run.side_by_side(list.size(), [&](std::size_t k) { speeds[k] = mean_speed(list[k], run); });
  std::size_t next = 0;
  for (const Way& way : ways) {
    for (const Layer& layer : layers) {
      const Material m = material_of(layer);
      const double slope = stopping_slope(m);
      std::vector<double> of_layer;
      for (const double offset : offsets) {
        of_layer.push_back(speeds[next++]);
        if (!way.judged) continue;
        run.add({.key = fmt::format("{}_{}_{:+.1f}", layer.key, way.key, offset),
                 .what = fmt::format("{}, {}: mean speed over the exact one, {:+.1f} deg",
                                     layer.name, way.name, offset),
                 .value = of_layer.back() / exact_speed(m, slope + offset * degree)});
      }
      Measure stop{.key = fmt::format("{}_{}_stop", layer.key, way.key),
                   .what = fmt::format("{}, {}: slope at which it stops, less {:.2f} deg",
                                       layer.name, way.name, slope / degree),
                   .value = crossing(of_layer, 2.0 * exact_speed(m, slope)),
                   .unit = "deg"};
      if (way.judged) {
        stop.lower = -0.5;
        stop.upper = 0.5;
        stop.reason = "the nearest slopes computed are half a degree away";
        stop.explanation =
            way.scheme == Scheme::corrected
                ? "a plug on a wall meets more than tau_y (slip planes), which moves the slope "
                  "while the sheared layer is thinner than the particles; with half as many "
                  "across, below, it moves farther"
                : "the paper's sums resist less than tau_y. The cause is not isolated; it is not "
                  "the "
                  "order of the particles (last rows)";
      }
      run.add(stop);
    }
  }
}

}  // namespace parapet::validation
