#include "states.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

namespace parapet::bench {

using solver::Flow;
using solver::FlowSetup;
using solver::InitialParticle;

solver::Scene h10_d45() {
  solver::Scene scene;
  solver::Barrier barrier;
  barrier.deflector = solver::Deflector{std::numbers::pi / 4.0, 0.065};
  scene.barriers = {barrier};
  return scene;
}

solver::Numerics numerics_of(double spacing) {
  solver::Numerics numerics;
  numerics.spacing = spacing;
  return numerics;
}

namespace {

void take_step(Flow& flow, double longest) {
  if (const auto failure = flow.step(longest)) throw std::runtime_error(failure->reason);
}

bool near_a_wall(const solver::Solids& solids, solver::Vec2 p, double distance) {
  for (const solver::Face& face : solids.faces) {
    if (solver::distance_to_segment(face.a, face.b, p) < distance) return true;
  }
  for (const solver::Body& body : solids.bodies) {
    if (!body.outline.empty() && solver::inside_polygon(body.outline, p)) return true;
  }
  return p.x < 0.0 || p.z < 0.0;
}

// Velocity and density of the flow at any place: the kernel's mean over the particles of its rows'
// owner `i` (Shepard), so that the fine particles find no steps where their parents meet.
void interpolate(const solver::FlowArrays& a, int i, InitialParticle& p) {
  double sum = 0.0, u = 0.0, w = 0.0, density = 0.0;
  const auto add = [&](int j) {
    const double q =
        std::hypot(p.x - a.fluid.x[j], p.z - a.fluid.z[j]) * a.constants.kernel.inverse_h;
    const double weight = solver::kernel_shape(q);
    sum += weight;
    u += weight * a.fluid.u[j];
    w += weight * a.fluid.w[j];
    density += weight * a.fluid.density[j];
  };
  add(i);
  const int g = i / solver::lanes;
  for (int s = a.rows.begin[g] + i % solver::lanes; s < a.rows.wall_begin[g]; s += solver::lanes) {
    add(a.rows.index[s]);
  }
  p.u = u / sum;
  p.w = w / sum;
  p.density = density / sum;
}

std::vector<InitialParticle> particles_of(const Flow& flow) {
  std::vector<InitialParticle> particles;
  for (int i = 0; i < flow.fluid().n; ++i) particles.push_back(flow.fluid().particle(i));
  return particles;
}

// Finer particles on a lattice wherever the flow is: cutting up its own, which overlap here and
// there, would leave particles in one place.
std::vector<InitialParticle> refined(Flow& flow, int refinement) {
  flow.prepare_neighbors();
  const solver::FlowArrays a = flow.arrays();
  const solver::Fluid& f = std::as_const(flow).fluid();
  const double dx = flow.setup().numerics.spacing, fine = dx / refinement;
  std::set<std::pair<int, int>> taken;
  std::vector<InitialParticle> particles;
  const auto first = [&](double x) { return static_cast<int>(std::ceil((x - 0.5 * dx) / fine)); };
  for (int i = 0; i < f.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    for (int kx = first(f.x[k]); kx < first(f.x[k]) + refinement; ++kx) {
      for (int kz = first(f.z[k]); kz < first(f.z[k]) + refinement; ++kz) {
        InitialParticle p{(kx + 0.5) * fine, (kz + 0.5) * fine, 0.0, 0.0, 0.0, 0.0};
        if (near_a_wall(flow.solids(), {p.x, p.z}, 0.1 * fine)) continue;
        if (!taken.insert({kx, kz}).second) continue;
        interpolate(a, i, p);
        p.mass = p.density * fine * fine;
        particles.push_back(p);
      }
    }
  }
  return particles;
}

}  // namespace

void advance(Flow& flow, int steps) {
  for (int k = 0; k < steps; ++k) take_step(flow, 1.0);
}

void advance_to(Flow& flow, double time) {
  while (time - flow.time() > 1e-9) take_step(flow, time - flow.time());
}

FlowSetup developed_flow(double spacing, double time, int refinement) {
  Flow flow(solver::channel_setup(h10_d45(), numerics_of(spacing), 1));
  advance_to(flow, time);
  FlowSetup setup = solver::channel_setup(h10_d45(), numerics_of(spacing / refinement), 1);
  setup.particles = refinement == 1 ? particles_of(flow) : refined(flow, refinement);
  setup.start_sound_speed = flow.sound_speed();
  if (refinement == 1) return setup;
  FlowSetup fresh = setup;
  fresh.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  Flow fine(std::move(fresh));
  advance(fine, std::min(200, 40 * refinement));
  setup.particles = particles_of(fine);
  setup.start_sound_speed = fine.sound_speed();
  return setup;
}

FlowSetup box(int n) {
  FlowSetup setup;
  setup.numerics = numerics_of(0.005);
  const double dx = setup.numerics.spacing;
  setup.particles = solver::lattice_block(0.0, 0.0, n * dx, n * dx, dx, setup.material.density);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> offset(-0.2 * dx, 0.2 * dx), speed(-1.0, 1.0);
  for (InitialParticle& p : setup.particles) {
    p.x += offset(random);
    p.z += offset(random);
    p.u = speed(random);
    p.w = speed(random);
  }
  return setup;
}

}  // namespace parapet::bench
