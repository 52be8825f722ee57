#include "pond_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "balance.hpp"
#include "flow_tools.hpp"
#include "parapet/flow/channel.hpp"

namespace parapet::validation::ponds {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;
using solver::InitialParticle;
using solver::Material;
using solver::Scene;

namespace {

constexpr double excess = 0.05;       // of the depth at the start [m]
constexpr double step = 1e-4;         // of the integration [m]
constexpr double time_to_rest = 6.0;  // [s]

}  // namespace

StaticLimit::StaticLimit(const Scene& scene, double height, double length, double stretching)
    : length_(length) {
  const Material& m = scene.material;
  const double normal = m.density * scene.gravity * std::cos(scene.slope);
  const double along = m.density * scene.gravity * std::sin(scene.slope);
  const auto slope = [&](double h) {
    return (along * h - m.yield_stress) /
           (normal * h - stretching * 0.5 * std::numbers::pi * m.yield_stress);
  };
  double h = height;
  for (double s = 0.0; s < length + step; s += step) {
    depth_.push_back(h);
    const double half = h - 0.5 * step * slope(h);
    h -= step * slope(half);
  }
}

double StaticLimit::depth(double s) const {
  const double at = std::clamp(s / step, 0.0, static_cast<double>(depth_.size() - 2));
  const auto k = static_cast<std::size_t>(at);
  return depth_[k] + (at - static_cast<double>(k)) * (depth_[k + 1] - depth_[k]);
}

double StaticLimit::volume() const {
  double sum = 0.0;
  const int n = static_cast<int>(std::round(length_ / step));
  for (int k = 0; k < n; ++k) sum += step * depth((k + 0.5) * step);
  return sum;
}

Scene scene_of(const Pond& pond) {
  Scene scene;
  scene.domain_length = pond.length + 0.12;
  scene.material.cutoff_shear_rate = pond.cutoff;
  solver::Barrier stem;
  stem.foot_x = pond.length;
  stem.height = pond.height;
  stem.stem_lean = -scene.slope;
  scene.barriers = {stem};
  return scene;
}

Outcome computed(const Pond& pond, const CaseRun& run) {
  const Scene scene = scene_of(pond);
  const StaticLimit limit(scene, pond.height, pond.length);
  solver::Numerics numerics;
  numerics.spacing = pond.spacing;
  numerics.sound_speed = 20.0;  // ten times what falls from the crest
  FlowSetup setup = solver::channel_setup(scene, numerics, 1);
  setup.particles.clear();
  if (pond.skimmed) setup.ceiling_z = pond.height;
  for (InitialParticle p : solver::lattice_block(0.0, 0.0, pond.length, pond.height + 2.0 * excess,
                                                 pond.spacing, scene.material.density)) {
    double depth = limit.depth(pond.length - p.x) + excess;
    if (pond.skimmed) depth = std::min(depth, pond.height);
    depth -= p.z;
    if (depth <= 0.0) continue;
    p.density -= scene.material.density * setup.gravity.z * depth /
                 (numerics.sound_speed * numerics.sound_speed);
    setup.particles.push_back(p);
  }
  Flow flow(std::move(setup));
  Balance balance(flow);
  Outcome out;
  double before = 0.0;
  const auto sample = [&](Flow& now) {
    const Fluid& f = std::as_const(now).fluid();
    double mass = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      if (f.x[i] < pond.length) mass += f.mass[i];
    }
    out.time.push_back(now.time());
    out.volume.push_back(mass / scene.material.density);
    out.inside += now.particles_inside_walls();
    if (now.time() < time_to_rest - 2.0 + 1e-9)
      before = balance.impulses().empty() ? 0.0 : balance.impulses()[0].force.x;
  };
  advance_sampled(flow, time_to_rest, 0.1, run, sample, &balance);
  const Fluid& f = std::as_const(flow).fluid();
  out.thrust = (balance.impulses()[0].force.x - before) / 2.0;
  const auto bins = static_cast<std::size_t>(std::round(pond.length / bin));
  out.surface.assign(bins, 0.0);
  for (std::size_t k = 0; k < bins; ++k) out.x.push_back((static_cast<double>(k) + 0.5) * bin);
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    if (f.x[i] >= pond.length) continue;
    out.speed = std::max(out.speed, std::hypot(f.u[i], f.w[i]));
    // a particle's mass is spread over a square of its volume
    const double side = std::sqrt(f.volume[i]), from = f.x[i] - 0.5 * side, to = from + side;
    for (std::size_t k = static_cast<std::size_t>(std::max(0.0, from / bin));
         k < bins && static_cast<double>(k) * bin < to; ++k) {
      const double left = static_cast<double>(k) * bin;
      const double overlap = std::min(to, left + bin) - std::max(from, left);
      out.surface[k] += f.mass[i] / scene.material.density * std::max(overlap, 0.0) / side / bin;
    }
  }
  out.depth_at_stem = out.surface.back();
  out.mass_change = balance.mass_change(flow);
  out.panel = speed_panel(flow, fmt::format("stem of {:.0f} mm, {}", 1e3 * pond.height,
                                            pond.skimmed ? "skimmed at the crest" : "free crest"));
  for (double& u : out.panel.quantity) u *= 1e3;
  out.walls = flow.solids().faces;
  return out;
}

double layer_speed(int rows, const CaseRun& run) {
  const Scene scene;
  Material material = scene.material;
  material.cutoff_shear_rate = 0.01;
  const double drive = material.density * scene.gravity * std::sin(scene.slope);
  const double h_c = material.yield_stress / drive, depth = 1.25 * h_c, n = material.flow_index;
  const double exact = n / (n + 1.0) * std::pow(drive / material.consistency, 1.0 / n) *
                       std::pow(depth - h_c, 1.0 + 1.0 / n);
  FlowSetup setup;
  setup.numerics.spacing = depth / rows;
  setup.numerics.sound_speed = 5.0;
  setup.numerics.cg_tolerance = 1e-3;
  setup.material = material;
  setup.gravity = {scene.gravity * std::sin(scene.slope), -scene.gravity * std::cos(scene.slope)};
  setup.periodic_length = 12.0 * setup.numerics.spacing;
  add_periodic_wall(setup, setup.periodic_length, 0.0, true);
  setup.particles = solver::lattice_block(0.0, 0.0, setup.periodic_length, depth,
                                          setup.numerics.spacing, material.density);
  for (InitialParticle& p : setup.particles) {
    p.u = exact * std::min(1.0, p.z / (depth - h_c));
    p.density -= material.density * setup.gravity.z * (depth - p.z) / 25.0;
  }
  Flow flow(std::move(setup));
  advance(flow, 1.0, run);
  const Fluid& f = std::as_const(flow).fluid();
  double speed = 0.0;
  int top = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    if (f.z[i] < 0.6 * depth) continue;
    speed += f.u[i];
    ++top;
  }
  return speed / top / exact;
}

}  // namespace parapet::validation::ponds
