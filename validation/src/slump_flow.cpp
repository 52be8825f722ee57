#include "slump_flow.hpp"

#include <fmt/format.h>

#include <utility>

#include "balance.hpp"
#include "flow_tools.hpp"
#include "parapet/flow/flow.hpp"

namespace parapet::validation::slumps {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;
using solver::InitialParticle;

namespace {

constexpr double bin = 0.02;  // over which depths are averaged [m]
constexpr int n_bins = 100;
constexpr double sound_speed = 13.0;  // 10 sqrt(g h) of the block [m/s]
constexpr double block_length = 0.4;  // of the released block [m]

FlowSetup slump_setup(const Slump& slump, const Material& material,
                      std::vector<InitialParticle> particles) {
  FlowSetup setup;
  setup.numerics.spacing = slump.spacing;
  setup.numerics.sound_speed = sound_speed;
  setup.material = material;
  setup.gravity = {0.0, -gravity};
  add_wall(setup, {0.0, 0.0}, {3.0, 0.0});
  add_wall(setup, {0.0, 1.0}, {0.0, 0.0});
  measure_all_walls(setup);
  setup.particles = std::move(particles);
  return setup;
}

std::vector<double> depths(const Fluid& f, double density) {
  std::vector<double> h(static_cast<std::size_t>(n_bins), 0.0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    // a particle's mass is spread over a square of its volume
    const double side = std::sqrt(f.volume[i]), from = f.x[i] - 0.5 * side, to = from + side;
    for (int k = std::max(0, static_cast<int>(from / bin)); k < n_bins && k * bin < to; ++k) {
      const double overlap = std::min(to, (k + 1) * bin) - std::max(from, k * bin);
      h[static_cast<std::size_t>(k)] += f.mass[i] / density * std::max(overlap, 0.0) / side / bin;
    }
  }
  return h;
}

// Foremost position where the depth falls through `level`.
double front_of(const std::vector<double>& h, double level) {
  for (std::size_t k = h.size() - 1; k-- > 0;) {
    if (h[k] < level) continue;
    const double share = (h[k] - level) / (h[k] - h[k + 1]);
    return (static_cast<double>(k) + 0.5 + share) * bin;
  }
  return 0.0;
}

}  // namespace

Material material_of(const Slump& slump) {
  Material m;
  m.yield_stress = slump.heap->yield_stress;
  m.cutoff_shear_rate = slump.cutoff;
  return m;
}

Outcome computed(const Slump& slump, const CaseRun& run) {
  Material material = material_of(slump);
  const double level = front_depth * Arrested(material, 0).depth_at_wall();
  Outcome out;
  double start_time = 0.0;
  const auto sample = [&](Flow& flow) {
    const Fluid& f = std::as_const(flow).fluid();
    out.depth = depths(f, material.density);
    out.time.push_back(start_time + flow.time());
    out.front.push_back(front_of(out.depth, level));
    out.inside += flow.particles_inside_walls();
  };
  std::vector<InitialParticle> particles = solver::lattice_block(
      0.0, 0.0, block_length, volume / block_length, slump.spacing, material.density);
  for (InitialParticle& p : particles) {
    p.density +=
        material.density * gravity * (volume / block_length - p.z) / (sound_speed * sound_speed);
  }
  for (const Stage& stage : slump.heap->stages) {
    material.consistency = stage.consistency;
    Flow flow(slump_setup(slump, material, particles));
    Balance balance(flow);
    advance_sampled(flow, stage.time, 0.1, run, sample, &balance);
    start_time += stage.time;
    // the first stage only brings the heap to where its inertia is small
    const bool released = &stage != &slump.heap->stages.front();
    const double speed = released ? flow.statistics().max_speed : 0.0;
    out.inertia =
        std::max(out.inertia, 0.5 * material.density * speed * speed / material.yield_stress);
    out.momentum_error = std::max(out.momentum_error, balance.momentum_error(flow));
    out.mass_change = std::max(out.mass_change, std::abs(balance.mass_change(flow)));
    out.energy_lost += balance.energy_loss(flow);
    out.dissipated += balance.dissipated();
    ParticlePanel panel = speed_panel(flow, fmt::format("t = {:.0f} s", start_time));
    for (double& u : panel.quantity) u *= 1e3;
    out.panels.push_back(panel);
    out.walls = flow.setup().solids.faces;
    const Fluid& f = std::as_const(flow).fluid();
    particles.clear();
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      particles.push_back({f.x[i], f.z[i], f.u[i], f.w[i], f.density[i], f.mass[i]});
    }
  }
  for (int k = 0; k < n_bins; ++k) out.x.push_back((k + 0.5) * bin);
  const std::size_t last = out.time.size() - 1, span = 50;
  out.front_speed =
      (out.front[last] - out.front[last - span]) / (out.time[last] - out.time[last - span]);
  return out;
}

double profile_error(const Outcome& o, const Arrested& theory) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < o.x.size(); ++k) {
    if (o.x[k] > theory.position(0.0)) break;
    const double h = theory.depth(o.x[k]);
    sum += (o.depth[k] - h) * (o.depth[k] - h);
    ++count;
  }
  return 100.0 * std::sqrt(sum / count) / theory.depth_at_wall();
}

}  // namespace parapet::validation::slumps
