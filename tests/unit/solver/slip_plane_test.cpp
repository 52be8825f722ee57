// What slides meets the yield stress once: forces of the viscous pairs at a jump in velocity,
// without a consistency, and the load on the wall beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "parapet/flow/flow.hpp"
#include "parapet/flow/walls.hpp"

namespace parapet::solver {
namespace {

constexpr double dx = 0.01, length = 24 * dx, height = 16 * dx;

// A lattice, periodic along x, on a wall or free.
FlowSetup block(bool on_wall) {
  FlowSetup setup;
  setup.numerics.spacing = dx;
  setup.numerics.cg_tolerance = 1e-6;
  setup.material.consistency = 0.0;
  setup.material.cutoff_shear_rate = 1e-6;
  setup.periodic_length = length;
  if (on_wall) {
    add_periodic_wall(setup, length, 0.0, true);
    measure_all_walls(setup);
  }
  setup.particles = lattice_block(0.0, 0.0, length, height, dx, setup.material.density);
  return setup;
}

// Force on what lies above z, over yield stress and length.
double resistance(Flow& flow, double z) {
  flow.evaluate();
  const Fluid& f = std::as_const(flow).fluid();
  std::vector<double> ax(f.x.size(), 0.0), az = ax;
  flow.add_viscous_force(ax, az);
  double force = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    if (f.z[i] > z) force -= f.mass[i] * ax[i];
  }
  return force / (flow.setup().material.yield_stress * length);
}

TEST(SlipPlane, InsideMeetsTheYieldStressOnce) {
  FlowSetup setup = block(false);
  for (InitialParticle& p : setup.particles) p.u = p.z > 8 * dx ? 1.0 : 0.0;
  Flow flow(std::move(setup));
  // Each particle's gradient holds its share of the jump, and the shares sum to one. With the rates
  // of the pairs instead it was 1.55.
  EXPECT_NEAR(resistance(flow, 8 * dx), 1.0, 1e-9);
}

TEST(SlipPlane, OnAWallMeetsTheYieldStressOnce) {
  for (const double speed : {0.01, 1.0}) {
    FlowSetup setup = block(true);
    for (InitialParticle& p : setup.particles) p.u = speed;
    Flow flow(std::move(setup));
    // 1.057: the second row sees the wall too, and its slope to it is counted beside that of the
    // first. It was 1.61.
    EXPECT_NEAR(resistance(flow, 0.0), 1.057, 0.001) << speed;
  }
}

TEST(SlipPlane, AMovingWallDragsWithWhatTheFluidLoses) {
  FlowSetup setup = block(true);
  setup.solids.faces.front().velocity = {1.0, 0.0};
  Flow flow(std::move(setup));
  const double force = -resistance(flow, 0.0);
  EXPECT_NEAR(force, 1.057, 0.001);
  flow.measure_barrier_load(1.0);
  const std::vector<BarrierImpulse> impulses = flow.take_impulses();
  ASSERT_EQ(impulses.size(), 1u);
  const double yield = flow.setup().material.yield_stress * length;
  EXPECT_NEAR(impulses[0].force.x / yield, -force, 1e-9);
}

TEST(SlipPlane, UniformShearMeetsTheYieldStress) {
  for (const bool on_wall : {false, true}) {
    FlowSetup setup = block(on_wall);
    for (InitialParticle& p : setup.particles) p.u = p.z / height;
    Flow flow(std::move(setup));
    EXPECT_NEAR(resistance(flow, on_wall ? 0.0 : 8 * dx), 1.0, 1e-9) << on_wall;
  }
}

// The implicit step against the same forces, beside a wall that moves.
TEST(SlipPlane, TheImplicitStepHasTheForceOfTheWall) {
  FlowSetup setup = block(true);
  setup.solids.faces.front().velocity = {1.0, 0.0};
  setup.material.cutoff_shear_rate = 0.1;  // nu dt/dx^2 = 1e-5 of what does not move
  Flow flow(std::move(setup));
  flow.evaluate();
  const Fluid& f = std::as_const(flow).fluid();
  std::vector<double> ax(f.x.size(), 0.0), az = ax, u = f.u, w = f.w;
  flow.add_viscous_force(ax, az);
  const double dt = 1e-9;
  ASSERT_TRUE(flow.solve_viscosity(f.u, f.w, u, w, dt));
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    difference += std::abs((u[i] - f.u[i]) / dt - ax[i]);
    size += std::abs(ax[i]);
  }
  ASSERT_GT(size, 0.0);
  EXPECT_LT(difference, 1e-3 * size);
}

}  // namespace
}  // namespace parapet::solver
