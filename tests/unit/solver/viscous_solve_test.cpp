// The implicit viscous step: symmetric, dissipative, momentum kept, and equal to the explicit force
// when the step is small.
#include "viscous_solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "parapet/flow/flow.hpp"

namespace parapet::solver {
namespace {

// A free block of Herschel-Bulkley fluid with random velocities.
std::unique_ptr<Flow> free_block() {
  FlowSetup setup;
  setup.numerics.spacing = 0.01;
  setup.numerics.cg_tolerance = 1e-9;
  setup.particles = lattice_block(0.0, 0.0, 0.15, 0.15, 0.01, setup.material.density);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> speed(-1.0, 1.0);
  for (InitialParticle& p : setup.particles) {
    p.u = speed(random);
    p.w = speed(random);
  }
  auto flow = std::make_unique<Flow>(std::move(setup));
  flow->evaluate();
  return flow;
}

TEST(ViscousSolve, KeepsMomentumAndTakesEnergyAway) {
  const auto flow = free_block();
  const Fluid& f = std::as_const(*flow).fluid();
  std::vector<double> u = f.u, w = f.w;
  ASSERT_TRUE(flow->solve_viscosity(f.u, f.w, u, w, 1e-3));
  double px = 0.0, pz = 0.0, before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    px += f.mass[i] * (u[i] - f.u[i]);
    pz += f.mass[i] * (w[i] - f.w[i]);
    before += f.u[i] * f.u[i] + f.w[i] * f.w[i];
    after += u[i] * u[i] + w[i] * w[i];
  }
  // the tolerance is an acceleration: 1e-9 m/s2 x 1 ms x 25.5 kg/m
  EXPECT_LT(std::abs(px) + std::abs(pz), 1e-10);
  // random motion at 100 1/s makes the fluid thin, nu dt/dx^2 = 0.03: about a quarter is dissipated
  EXPECT_LT(after, 0.9 * before);
}

TEST(ViscousSolve, AgreesWithTheExplicitForceForSmallSteps) {
  const auto flow = free_block();
  const Fluid& f = std::as_const(*flow).fluid();
  std::vector<double> ax(f.u.size(), 0.0), az = ax, u = f.u, w = f.w;
  flow->add_viscous_force(ax, az);
  const double dt = 1e-9;  // backward and forward Euler differ by dt |A| ~ 1e-5
  ASSERT_TRUE(flow->solve_viscosity(f.u, f.w, u, w, dt));
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    difference += std::abs((u[i] - f.u[i]) / dt - ax[i]) + std::abs((w[i] - f.w[i]) / dt - az[i]);
    size += std::abs(ax[i]) + std::abs(az[i]);
  }
  EXPECT_LT(difference, 1e-3 * size);
}

}  // namespace
}  // namespace parapet::solver
