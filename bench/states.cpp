#include "states.hpp"

#include <numbers>
#include <random>
#include <stdexcept>
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

std::vector<InitialParticle> refined(const Flow& flow, int refinement) {
  const solver::Fluid& f = flow.fluid();
  const double dx = flow.setup().numerics.spacing, fine = dx / refinement;
  std::vector<InitialParticle> particles;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const double mass = f.mass[i] / (refinement * refinement);
    for (int kx = 0; kx < refinement; ++kx) {
      for (int kz = 0; kz < refinement; ++kz) {
        const InitialParticle p{f.x[i] - 0.5 * dx + (kx + 0.5) * fine,
                                f.z[i] - 0.5 * dx + (kz + 0.5) * fine,
                                f.u[i],
                                f.w[i],
                                f.density[i],
                                mass};
        if (refinement > 1 && near_a_wall(flow.solids(), {p.x, p.z}, 0.1 * fine)) continue;
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

void prepare(Flow& flow) {
  flow.prepare_neighbors();
  flow.update_pressure();
  flow.update_gradients();
}

FlowSetup developed_flow(double spacing, double time, int refinement) {
  Flow flow(solver::channel_setup(h10_d45(), numerics_of(spacing), 1));
  advance_to(flow, time);
  FlowSetup setup = solver::channel_setup(h10_d45(), numerics_of(spacing / refinement), 1);
  setup.particles = refined(flow, refinement);
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
