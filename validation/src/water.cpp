#include "water.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

#include "flow_tools.hpp"
#include "parapet/flow/flow.hpp"
#include "parapet/flow/kernel.hpp"

namespace parapet::validation {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;

namespace {

// Pressure at the moment after the release [Pa]: the incompressible fluid still is at rest, its
// right side now is free. Laplace's equation with the hydrostatic slope at the walls,
// p = rho g (D - z) - sum a_n cos(k_n z) cosh(k_n x)/cosh(k_n L). A start from the pressure at rest
// would send a sound wave of its size through the column.
double released_pressure(const WaterTank& tank, double x, double z) {
  const double depth = tank.column_depth;
  double p = depth - z;
  for (int n = 0; n < 200; ++n) {
    const double k = (n + 0.5) * std::numbers::pi / depth;
    // cosh(k x)/cosh(k L) without large numbers
    const double decay = std::exp(k * (x - tank.column_length)) * (1.0 + std::exp(-2.0 * k * x)) /
                         (1.0 + std::exp(-2.0 * k * tank.column_length));
    p -= 2.0 / (depth * k * k) * std::cos(k * z) * decay;
  }
  return water_density * gravity * std::max(p, 0.0);
}

}  // namespace

double viscosity_of_alpha(const WaterTank& tank, double alpha) {
  const double h = solver::Numerics{}.smoothing_ratio * tank.spacing;
  return alpha * water_density * tank.sound_speed * h / 8.0;
}

double available_energy(const WaterTank& tank) {
  const double area = tank.column_length * tank.column_depth;
  return 0.5 * water_density * gravity * area * (tank.column_depth - area / tank.length);
}

FlowSetup water_setup(const WaterTank& tank) {
  FlowSetup setup;
  setup.numerics.spacing = tank.spacing;
  setup.numerics.sound_speed = tank.sound_speed;
  setup.numerics.shifting_factor = tank.shifting;
  setup.material.density = water_density;
  setup.material.yield_stress = 0.0;
  setup.material.consistency = tank.viscosity;
  setup.material.flow_index = 1.0;
  setup.gravity = {0.0, -gravity};
  setup.wall_slip = tank.slip;
  add_wall(setup, {0.0, 0.0}, {tank.length, 0.0});
  add_wall(setup, {0.0, tank.wall_height}, {0.0, 0.0});
  add_wall(setup, {tank.length, 0.0}, {tank.length, tank.wall_height});
  measure_all_walls(setup);
  setup.n_barriers = 2;
  setup.solids.faces.back().barrier = 1;
  setup.particles = solver::lattice_block(0.0, 0.0, tank.column_length, tank.column_depth,
                                          tank.spacing, water_density);
  std::mt19937_64 random(tank.seed);
  const auto offset = [&] {
    // 53 random bits, the same on every standard library
    const double unit = static_cast<double>(random() >> 11) * 0x1.0p-53;
    return tank.seed == 0 ? 0.0 : (2.0 * unit - 1.0) * 0.1 * tank.spacing;
  };
  for (solver::InitialParticle& p : setup.particles) {
    p.x += offset();
    p.z += offset();
    p.density += released_pressure(tank, p.x, p.z) / (tank.sound_speed * tank.sound_speed);
  }
  return setup;
}

double Series::at(double time) const {
  const auto after =
      static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), time) - t.begin());
  if (after == 0) return value.front();
  if (after == t.size()) return value.back();
  const double share = (time - t[after - 1]) / (t[after] - t[after - 1]);
  return value[after - 1] + share * (value[after] - value[after - 1]);
}

double Series::first_reaches(double level) const {
  for (std::size_t k = 0; k < t.size(); ++k) {
    if (value[k] < level) continue;
    if (k == 0) return t[0];
    return t[k - 1] + (level - value[k - 1]) / (value[k] - value[k - 1]) * (t[k] - t[k - 1]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double Series::integral(double from, double to) const {
  double sum = 0.0, last_t = from, last_v = at(from);
  for (auto k = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), from) - t.begin());
       k < t.size() && t[k] < to; ++k) {
    sum += 0.5 * (last_v + value[k]) * (t[k] - last_t);
    last_t = t[k];
    last_v = value[k];
  }
  return sum + 0.5 * (last_v + at(to)) * (to - last_t);
}

double Series::mean_around(double time, double half) const {
  return half > 0.0 ? integral(time - half, time + half) / (2.0 * half) : at(time);
}

double depth_at(const Flow& flow, double x, double width, double gap) {
  const Fluid& f = flow.fluid();
  const double dx = flow.setup().numerics.spacing;
  std::vector<std::pair<double, double>> column;  // z, mass in the strip
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const double from = std::max(f.x[i] - 0.5 * dx, x - 0.5 * width);
    const double to = std::min(f.x[i] + 0.5 * dx, x + 0.5 * width);
    if (to > from) column.emplace_back(f.z[i], f.mass[i] * (to - from) / dx);
  }
  std::ranges::sort(column);
  double mass = 0.0, top = 0.0;
  for (const auto& [z, m] : column) {
    if (z - top >= gap) break;
    mass += m;
    top = z;
  }
  return mass / (flow.setup().material.density * width);
}

double front_position(const Flow& flow, double share) {
  const Fluid& f = flow.fluid();
  std::vector<std::size_t> order(static_cast<std::size_t>(f.n));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return std::pair(f.x[a], f.id[a]) > std::pair(f.x[b], f.id[b]);
  });
  double total = 0.0;
  for (const std::size_t i : order) total += f.mass[i];
  // each particle is spread over one spacing
  double ahead = 0.0;
  for (const std::size_t i : order) {
    ahead += f.mass[i];
    if (ahead < share * total) continue;
    const double inside = (ahead - share * total) / f.mass[i];
    return f.x[i] + (inside - 0.5) * flow.setup().numerics.spacing;
  }
  return 0.0;
}

double pressure_at_wall(const Flow& flow, double x, double z) {
  const Fluid& f = flow.fluid();
  const double h = flow.smoothing_length(), reach = 2.0 * h;
  double weight = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const double rx = x - f.x[i], rz = z - f.z[i];
    if (std::abs(rx) > reach || std::abs(rz) > reach) continue;
    const double w = solver::kernel_shape(std::hypot(rx, rz) / h);
    const solver::Vec2 g = flow.setup().gravity;
    weight += w;
    sum += w * (f.pressure[i] + f.density[i] * (g.x * rx + g.z * rz));
  }
  return weight > 0.0 ? std::max(sum / weight, 0.0) : 0.0;
}

void follow(Flow& flow, double end, const CaseRun& run, Balance& balance,
            const std::function<void(Flow&)>& each) {
  flow.refresh();
  each(flow);
  while (end - flow.time() > 1e-12) {
    run.check_cancelled();
    if (const auto failure = flow.step(end - flow.time())) {
      throw std::runtime_error(failure->reason + " at t = " + std::to_string(flow.time()) + " s");
    }
    balance.add_step(flow);
    flow.refresh();
    each(flow);
  }
  run.watch_masses(flow);
}

}  // namespace parapet::validation
