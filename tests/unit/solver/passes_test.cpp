// Every neighbour sum on a handful of particles against the plain double loop of its equation, and
// the instruction sets against each other bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cloud.hpp"
#include "parapet/flow/shifting.hpp"

namespace parapet::solver {
namespace {

constexpr double dx = cloud_dx, h = cloud_h, kappa = cloud_levelling;

TEST(Passes, PressureForceIsEquation6WithTensileControl) {
  const Cloud cloud;
  const Fluid& f = cloud.fluid;
  std::vector<double> ax(static_cast<std::size_t>(f.n)), az = ax;
  best_passes().pressure_force(cloud.arrays(), ax.data(), az.data(), 0, f.n);
  for (std::size_t i = 0; i < 5; ++i) {
    Vec2 sum;
    cloud.for_neighbors(i, [&](std::size_t j, Vec2 r, double fv) {
      sum = sum + (f.pressure[j] + f.tic[i] * f.pressure[i]) * fv * r;
    });
    EXPECT_NEAR(ax[i], -sum.x / f.density[i], 1e-9 * std::abs(ax[i]) + 1e-12);
    EXPECT_NEAR(az[i], -sum.z / f.density[i], 1e-9 * std::abs(az[i]) + 1e-12);
  }
}

TEST(Passes, ViscousForceHasAlphaEightAndTheMeanViscosity) {
  const Cloud cloud;
  const Fluid& f = cloud.fluid;
  std::vector<double> ax(static_cast<std::size_t>(f.n), 0.0), az = ax;
  best_passes().viscous_force(cloud.arrays(), ax.data(), az.data(), 0, f.n);
  for (std::size_t i = 0; i < 5; ++i) {
    Vec2 sum;
    cloud.for_neighbors(i, [&](std::size_t j, Vec2 r, double fv) {
      const double eta = 0.5 * (f.pair_viscosity[i] + f.pair_viscosity[j]);
      const Vec2 du{f.u[i] - f.u[j], f.w[i] - f.w[j]};
      sum = sum + 8.0 * eta * dot(du, r) / dot(r, r) * fv * r;
    });
    // the guard of r^2 against zero is (1e-6 h)^2
    EXPECT_NEAR(ax[i], sum.x / f.density[i], 1e-8 * std::abs(ax[i]));
    EXPECT_NEAR(az[i], sum.z / f.density[i], 1e-8 * std::abs(az[i]));
  }
}

TEST(Passes, ViscousPairForcesKeepBothMomenta) {
  const Cloud cloud;
  const Fluid& f = cloud.fluid;
  std::vector<double> ax(static_cast<std::size_t>(f.n), 0.0), az = ax;
  best_passes().viscous_force(cloud.arrays(), ax.data(), az.data(), 0, f.n);
  double px = 0.0, pz = 0.0, spin = 0.0, size = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    px += f.mass[i] * ax[i];
    pz += f.mass[i] * az[i];
    spin += f.mass[i] * (f.x[i] * az[i] - f.z[i] * ax[i]);
    size += f.mass[i] * (std::abs(ax[i]) + std::abs(az[i]));
  }
  EXPECT_LT(std::abs(px) + std::abs(pz), 1e-13 * size);  // rounding alone
  EXPECT_LT(std::abs(spin), 1e-13 * size * 0.03);        // lever arms up to 0.03 m
}

TEST(Passes, DensityRateIsEquations6And7WithWhatShiftingExchanges) {
  const Cloud cloud;
  const Fluid& f = cloud.fluid;
  const Rates rates = cloud.rates();
  for (std::size_t i = 0; i < 5; ++i) {
    double expected = 0.0, diffusion = 0.0, flux = 0.0, levelled = 0.0;
    Vec2 exchange{};
    const Vec2 ui{f.u[i], f.w[i]}, shift_i{f.shift_u[i], f.shift_w[i]};
    cloud.for_neighbors(i, [&](std::size_t j, Vec2 r, double fv) {
      const Vec2 uj{f.u[j], f.w[j]}, grad = fv * r, shift_j{f.shift_u[j], f.shift_w[j]};
      expected += -f.density[i] * dot(uj + shift_j - ui - shift_i, grad);
      const double pair = dot(f.density[i] * shift_i + f.density[j] * shift_j, grad);
      const double even =
          -2.0 * kappa / (dx * dx) * fv * (f.density[j] * f.volume[j] - f.density[i] * f.volume[i]);
      flux += pair;
      levelled += even;
      exchange = exchange + (0.5 * (pair + even) * f.volume[i]) * (uj - ui);
      const Vec2 slopes{f.density_grad_x[i] + f.density_grad_x[j],
                        f.density_grad_z[i] + f.density_grad_z[j]};
      const Vec2 rji = -1.0 * r;
      diffusion +=
          (2.0 * (f.density[j] - f.density[i]) - dot(slopes, rji)) * dot(rji, grad) / dot(r, r);
    });
    expected += flux + 0.1 * h * 35.0 * diffusion;
    EXPECT_NEAR(rates.density[i], expected, 1e-9 * std::abs(expected));
    const double mass_rate = f.volume[i] * (flux + levelled);
    EXPECT_NEAR(rates.mass[i], mass_rate, 1e-9 * std::abs(mass_rate));
    EXPECT_NEAR(rates.exchange_x[i], exchange.x, 1e-9 * norm(exchange));
    EXPECT_NEAR(rates.exchange_z[i], exchange.z, 1e-9 * norm(exchange));
  }
}

TEST(Passes, ShiftingKeepsMassMomentumAndKineticEnergy) {
  const Cloud cloud;
  const Fluid& f = cloud.fluid;
  const Rates rates = cloud.rates();
  double mass = 0.0, px = 0.0, energy = 0.0, mass_size = 0.0, px_size = 0.0, energy_size = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    // d(m u)/dt = u dm/dt + m du/dt
    const double momentum_rate = f.u[i] * rates.mass[i] + rates.exchange_x[i];
    const double speed2 = f.u[i] * f.u[i] + f.w[i] * f.w[i];
    const double energy_rate =
        0.5 * speed2 * rates.mass[i] + f.u[i] * rates.exchange_x[i] + f.w[i] * rates.exchange_z[i];
    mass += rates.mass[i];
    px += momentum_rate;
    energy += energy_rate;
    mass_size += std::abs(rates.mass[i]);
    px_size += std::abs(momentum_rate);
    energy_size += std::abs(energy_rate);
  }
  ASSERT_GT(std::min({mass_size, px_size, energy_size}), 0.0);
  EXPECT_LT(std::abs(mass), 1e-13 * mass_size);  // rounding alone, here and below
  EXPECT_LT(std::abs(px), 1e-13 * px_size);
  EXPECT_LT(std::abs(energy), 1e-13 * energy_size);
}

TEST(Passes, EveryInstructionSetGivesTheSameBits) {
  const Cloud cloud;
  const auto n = static_cast<std::size_t>(cloud.fluid.n);
  std::vector<double> reference;
  int compared = 0;
  for (const char* name : {"x86_64", "x86_64_v3", "x86_64_v4"}) {
    const PassTable* table = find_passes(name);
    if (table == nullptr) continue;  // this machine cannot run it
    std::vector<double> all(8 * n, 0.0);
    double* p = all.data();
    table->pressure_force(cloud.arrays(), p, p + n, 0, cloud.fluid.n);
    table->viscous_force(cloud.arrays(), p + 2 * n, p + 3 * n, 0, cloud.fluid.n);
    table->density_rate(cloud.arrays(), {p + 4 * n, p + 5 * n, p + 6 * n, p + 7 * n}, 0,
                        cloud.fluid.n);
    if (reference.empty()) reference = all;
    EXPECT_EQ(all, reference) << name;
    ++compared;
  }
  EXPECT_GE(compared, 1);
}

TEST(Passes, RenormalisedGradientsAreExactForLinearFields) {
  // A jittered block without walls: density gradient and strain rate of linear fields, everywhere
  FlowSetup setup;
  setup.numerics.spacing = dx;
  setup.material.density = 1000.0;
  setup.particles = lattice_block(0.0, 0.0, 0.2, 0.2, dx, 1000.0);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> offset(-0.2 * dx, 0.2 * dx);
  for (InitialParticle& p : setup.particles) {
    p.x += offset(random);
    p.z += offset(random);
    p.density = 1000.0 + 30.0 * p.x - 20.0 * p.z;
    p.u = 2.0 * p.x + 3.0 * p.z;
    p.w = 5.0 * p.x - 2.0 * p.z;
  }
  setup.wall_slip = WallSlip::free_slip;
  Flow flow(std::move(setup));
  flow.evaluate();
  const Fluid& f = static_cast<const Flow&>(flow).fluid();
  // 2 S:S = 2 (4 + 4) + (3 + 5)^2 = 80; at the surface part of the pairs that shear is missing
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    EXPECT_NEAR(f.density_grad_x[i], 30.0, 1e-9);
    EXPECT_NEAR(f.density_grad_z[i], -20.0, 1e-9);
    const double margin = std::min(std::min(f.x[i], 0.2 - f.x[i]), std::min(f.z[i], 0.2 - f.z[i]));
    if (margin > 3.0 * dx) {
      // a jittered neighbourhood's support is up to 10 % short of the full one, and counts as its
      // root
      EXPECT_GT(f.shear_rate[i], 0.95 * std::sqrt(80.0));
    }
    EXPECT_LT(f.shear_rate[i], std::sqrt(80.0) + 1e-9);
  }
}

TEST(Passes, ShiftingMovesDisplacedParticlesBackAndLeavesTheSurfaceAlone) {
  FlowSetup setup;
  setup.numerics.spacing = dx;
  setup.particles = lattice_block(0.0, 0.0, 0.2, 0.2, dx, setup.material.density);
  constexpr std::size_t displaced = 10 * 20 + 10;  // in the middle
  setup.particles[displaced].x += 0.3 * dx;
  setup.particles[displaced].z -= 0.2 * dx;
  Flow flow(std::move(setup));
  flow.evaluate();
  Fluid& f = flow.fluid();
  constexpr double largest_speed = 2.0;
  finish_gradients(f, flow.gradient_sums().view, {h, largest_speed, 1.0, false, 0.0}, Material{}, 0,
                   f.n);
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    EXPECT_LE(std::hypot(f.shift_u[i], f.shift_w[i]), 0.5 * largest_speed + 1e-12);
    const double margin = std::min(std::min(f.x[i], 0.2 - f.x[i]), std::min(f.z[i], 0.2 - f.z[i]));
    if (margin < dx) {
      EXPECT_EQ(f.shift_u[i], 0.0);
      EXPECT_EQ(f.shift_w[i], 0.0);
    }
    if (static_cast<std::size_t>(f.id[i]) == displaced) {
      EXPECT_LT(f.shift_u[i], -0.01 * largest_speed);
      EXPECT_GT(f.shift_w[i], 0.01 * largest_speed);
    }
  }
}

// Eq. 9 is proportional to u_max. Kept for a time T it may not carry a particle at that speed
// farther than 0.15 dx: beyond, the velocity falls with 1/T.
TEST(Passes, ShiftingThatIsKeptForLongIsSlower) {
  FlowSetup setup;
  setup.numerics.spacing = dx;
  setup.particles = lattice_block(0.0, 0.0, 0.2, 0.2, dx, setup.material.density);
  constexpr double speed = 3.0;
  for (InitialParticle& p : setup.particles) p.u = speed;
  constexpr std::size_t displaced = 10 * 20 + 10;  // in the middle
  setup.particles[displaced].x += 0.3 * dx;
  Flow flow(std::move(setup));
  ASSERT_FALSE(flow.step(1e-7));  // looks at the speeds
  const auto shift_after = [&](double interval) {
    flow.update_gradients(interval);
    const Fluid& f = static_cast<const Flow&>(flow).fluid();
    const auto found = std::find(f.id.begin(), f.id.end(), static_cast<int>(displaced));
    return f.shift_u[static_cast<std::size_t>(found - f.id.begin())];
  };
  const double free = shift_after(0.0), longest = 0.15 * dx / speed;
  ASSERT_LT(free, -0.01 * speed);
  EXPECT_EQ(shift_after(0.99 * longest), free);
  // the step has changed the largest speed by less than a thousandth
  EXPECT_NEAR(shift_after(4.0 * longest) / free, 0.25, 1e-3);
}

TEST(Passes, ViscousPowerIsTheDissipationOfTheShearRates) {
  // sum m u . a = -sum V eta g^2 to rounding, whatever the velocities and the viscosities
  FlowSetup setup;
  setup.numerics.spacing = dx;
  setup.particles = lattice_block(0.0, 0.0, 0.1, 0.1, dx, setup.material.density);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-0.3 * dx, 0.3 * dx), speed(-1.0, 1.0);
  for (InitialParticle& p : setup.particles) {
    p.x += offset(random);
    p.z += offset(random);
    p.u = speed(random);
    p.w = speed(random);
  }
  Flow flow(std::move(setup));
  flow.evaluate();
  const Fluid& f = static_cast<const Flow&>(flow).fluid();
  std::vector<double> ax(f.x.size(), 0.0), az = ax;
  flow.add_viscous_force(ax, az);
  double power = 0.0, dissipation = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    power += f.mass[i] * (f.u[i] * ax[i] + f.w[i] * az[i]);
    dissipation += f.volume[i] * f.viscosity[i] * f.shear_rate[i] * f.shear_rate[i];
  }
  EXPECT_GT(dissipation, 0.0);
  EXPECT_NEAR(-power / dissipation, 1.0, 1e-12);
}

TEST(Passes, CentralForcePullsTowardsTheOrigin) {
  FlowSetup setup;
  setup.numerics.spacing = dx;
  setup.gravity = {0.5, -2.0};
  setup.central_force = 9.0;
  const double rho = setup.material.density;
  setup.particles = {{0.2, -0.1, 0.0, 0.0, rho, 0.1}, {-1.0, 2.0, 0.0, 0.0, rho, 0.1}};
  Flow flow(std::move(setup));
  flow.prepare_neighbors();
  flow.update_pressure();
  const Fluid& f = static_cast<const Flow&>(flow).fluid();
  std::vector<double> ax(f.x.size(), 0.0), az = ax;
  flow.add_body_and_pressure_force(ax, az);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_DOUBLE_EQ(ax[i], 0.5 - 9.0 * f.x[i]);
    EXPECT_DOUBLE_EQ(az[i], -2.0 - 9.0 * f.z[i]);
  }
}

}  // namespace
}  // namespace parapet::solver
