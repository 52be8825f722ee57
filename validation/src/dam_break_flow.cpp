#include "dam_break_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flow_tools.hpp"

namespace parapet::validation {

using solver::Flow;

namespace {

// Square of the mean speed in a strip around x.
double stream_speed2(const Flow& flow, double x, double width) {
  const solver::Fluid& f = flow.fluid();
  double mass = 0.0, momentum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    if (std::abs(f.x[i] - x) > 0.5 * width || f.z[i] > 0.1) continue;
    mass += f.mass[i];
    momentum += f.mass[i] * f.u[i];
  }
  return mass > 0.0 ? momentum * momentum / (mass * mass) : 0.0;
}

}  // namespace

double DamBreakRecord::peak(std::size_t sensor, double window) const {
  const Series& p = pressure[sensor];
  double largest = 0.0;
  for (std::size_t k = 0; k < p.t.size(); ++k) {
    if (p.t[k] < arrival || p.t[k] > arrival + 1.0) continue;
    largest = std::max(largest, p.mean_around(p.t[k], 0.5 * window));
  }
  return largest;
}

double DamBreakRecord::peak_force(double window) const {
  double largest = 0.0;
  for (const double t : impulse.t) {
    if (t < arrival || t > arrival + 1.0) continue;
    const double half = 0.5 * window;
    largest = std::max(largest, (impulse.at(t + half) - impulse.at(t - half)) / window);
  }
  return largest;
}

DamBreakRecord simulated(const DamBreak& dam, const Lobovsky& measured, const CaseRun& run) {
  const double H = dam.depth, unit = std::sqrt(H / gravity);  // [m], [s]
  WaterTank tank;
  tank.column_length = measured.reservoir_length;
  tank.column_depth = H;
  tank.length = measured.tank_length;
  tank.wall_height = 4.0 * H;  // the jet must not pass the end of a wall
  tank.spacing = dam.spacing;
  tank.sound_speed = dam.sound_factor * std::sqrt(gravity * H);
  tank.viscosity = dam.alpha > 0.0 ? viscosity_of_alpha(tank, dam.alpha) : 1e-3;
  tank.slip = dam.slip;
  tank.seed = dam.seed;
  DamBreakRecord r;
  r.flow = std::make_unique<Flow>(water_setup(tank));
  r.balance = std::make_unique<Balance>(*r.flow);
  const double p_unit = water_density * gravity * H, available = available_energy(tank);
  double next_sample = 0.0, wall_impulse = 0.0;
  bool impact = false;
  std::vector<double> pictures = dam.pictures;
  follow(*r.flow, dam.end * unit, run, *r.balance, [&](Flow& f) {
    const double t = f.time() / unit;
    for (std::size_t k = 0; k < 4; ++k) {
      r.pressure[k].add(t, pressure_at_wall(f, tank.length, measured.sensor_z[k]) / p_unit);
    }
    if (f.time() > 0.0) wall_impulse += r.balance->last_impulses()[1].force.x / (p_unit * H * unit);
    r.impulse.add(t, wall_impulse);
    if (!impact && t >= 2.2) {
      impact = true;
      r.loss_before_impact = r.balance->numerical_share(f, available);
    }
    if (!pictures.empty() && t >= pictures.front()) {
      const std::string title = fmt::format("t* = {:.1f}", pictures.front());
      r.speed.push_back(speed_panel(f, title));
      r.pressures.push_back(pressure_panel(f, title, p_unit));
      pictures.erase(pictures.begin());
    }
    if (t < next_sample) return;
    next_sample += 0.02;
    for (std::size_t k = 0; k < 4; ++k) {
      r.depth[k].add(t, depth_at(f, measured.levels[k].x, 0.1 * H, 0.1 * H) / H);
    }
    r.front.add(t, (front_position(f, 5e-4) - tank.column_length) / H);
    const double speed2 = stream_speed2(f, measured.levels[3].x, 0.1 * H);
    r.head.add(t, r.depth[3].value.back() + speed2 / (2.0 * gravity * H));
  });
  r.arrival = r.pressure[0].first_reaches(0.05);
  r.loss_at_end = r.balance->numerical_share(*r.flow, available);
  r.viscous_at_end = r.balance->dissipated() / available;
  return r;
}

double cost_of(const DamBreak& dam) {
  const double particles = 0.6 * dam.depth / (dam.spacing * dam.spacing);
  const double steps = 3.6 * dam.sound_factor * dam.end * dam.depth / dam.spacing / 1.7;
  return 0.85e-6 * particles * steps;
}

}  // namespace parapet::validation
