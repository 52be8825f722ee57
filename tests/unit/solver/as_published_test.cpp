// Scheme as_published: every sum against the plain double loop of its equation, what the pair
// forces keep, and the instruction sets against each other.
#include "parapet/flow/as_published.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cloud.hpp"

namespace parapet::solver {
namespace {

constexpr double h = cloud_h;

const PassTable& passes() {
  return best_passes(Scheme::as_published);
}

double harmonic(double a, double b) {
  return 2.0 * a * b / (a + b);
}

std::size_t size_of(const Fluid& f) {
  return static_cast<std::size_t>(f.n);
}

TEST(AsPublished, ViscousForceHasAlphaEightAndTheHarmonicMean) {
  const Cloud cloud;
  const Fluid& f = cloud.fluid;
  std::vector<double> ax(size_of(f), 0.0), az = ax;
  passes().viscous_force(cloud.arrays(), ax.data(), az.data(), 0, f.n);
  for (std::size_t i = 0; i < 5; ++i) {
    Vec2 sum;
    cloud.for_neighbors(i, [&](std::size_t j, Vec2 r, double fv) {
      const double eta = harmonic(f.pair_viscosity[i], f.pair_viscosity[j]);
      const Vec2 du{f.u[i] - f.u[j], f.w[i] - f.w[j]};
      sum = sum + 8.0 * eta * dot(du, r) / dot(r, r) * fv * r;
    });
    // the guard of r^2 against zero is (1e-6 h)^2
    EXPECT_NEAR(ax[i], sum.x / f.density[i], 1e-8 * std::abs(ax[i]));
    EXPECT_NEAR(az[i], sum.z / f.density[i], 1e-8 * std::abs(az[i]));
  }
}

TEST(AsPublished, ViscousPairForcesKeepBothMomenta) {
  const Cloud cloud;
  const Fluid& f = cloud.fluid;
  std::vector<double> ax(size_of(f), 0.0), az = ax;
  passes().viscous_force(cloud.arrays(), ax.data(), az.data(), 0, f.n);
  double px = 0.0, pz = 0.0, spin = 0.0, size = 0.0;
  for (std::size_t i = 0; i < size_of(f); ++i) {
    px += f.mass[i] * ax[i];
    pz += f.mass[i] * az[i];
    spin += f.mass[i] * (f.x[i] * az[i] - f.z[i] * ax[i]);
    size += f.mass[i] * (std::abs(ax[i]) + std::abs(az[i]));
  }
  ASSERT_GT(size, 0.0);
  EXPECT_LT(std::abs(px) + std::abs(pz), 1e-13 * size);  // rounding alone
  EXPECT_LT(std::abs(spin), 1e-13 * size * 0.03);        // lever arms up to 0.03 m
}

TEST(AsPublished, DensityRateAndShiftingTermsAreEquations6And7WithConstantMasses) {
  const Cloud cloud;
  const Fluid& f = cloud.fluid;
  const Rates rates = cloud.rates(passes());
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec2 u{f.u[i], f.w[i]}, shift{f.shift_u[i], f.shift_w[i]};
    double rate = 0.0, diffusion = 0.0, second = 0.0;
    Vec2 first;
    cloud.for_neighbors(i, [&](std::size_t j, Vec2 r, double fv) {
      const Vec2 uj{f.u[j], f.w[j]}, shift_j{f.shift_u[j], f.shift_w[j]}, grad = fv * r;
      const Vec2 here = f.density[i] * shift, there = f.density[j] * shift_j;
      rate += -f.density[i] * dot(uj + shift_j - u - shift, grad) + dot(there + here, grad);
      first = first + dot(there, grad) * uj + dot(here, grad) * u;
      second += dot(there - here, grad);
      const Vec2 slopes{f.density_grad_x[i] + f.density_grad_x[j],
                        f.density_grad_z[i] + f.density_grad_z[j]};
      const Vec2 rji = -1.0 * r;
      diffusion +=
          (2.0 * (f.density[j] - f.density[i]) - dot(slopes, rji)) * dot(rji, grad) / dot(r, r);
    });
    rate += 0.1 * h * 35.0 * diffusion;
    EXPECT_NEAR(rates.density[i], rate, 1e-9 * std::abs(rate));
    EXPECT_EQ(rates.mass[i], 0.0);
    const Vec2 momentum = f.volume[i] * (first - second * u);
    EXPECT_NEAR(rates.exchange_x[i], momentum.x, 1e-9 * norm(momentum));
    EXPECT_NEAR(rates.exchange_z[i], momentum.z, 1e-9 * norm(momentum));
  }
}

// Of the two sums for the momentum the first is opposite and equal in a pair. The second is not:
// all that shifting does to the momentum of the whole is its sum.
TEST(AsPublished, ShiftingLosesTheMomentumOfItsSecondSumAlone) {
  const Cloud cloud;
  const Fluid& f = cloud.fluid;
  const Rates rates = cloud.rates(passes());
  double whole = 0.0, second = 0.0, size = 0.0;
  for (std::size_t i = 0; i < size_of(f); ++i) {
    const Vec2 here = f.density[i] * Vec2{f.shift_u[i], f.shift_w[i]};
    cloud.for_neighbors(i, [&](std::size_t j, Vec2 r, double fv) {
      const Vec2 there = f.density[j] * Vec2{f.shift_u[j], f.shift_w[j]};
      second -= f.volume[i] * f.u[i] * dot(there - here, fv * r);
    });
    whole += rates.exchange_x[i];
    size += std::abs(rates.exchange_x[i]);
  }
  EXPECT_NEAR(whole, second, 1e-12 * size);  // rounding alone
  EXPECT_GT(std::abs(whole), 1e-3 * size);   // so it is lost indeed
}

TEST(AsPublished, EquationOfStateHasABackgroundPressure) {
  Cloud cloud;
  Fluid& f = cloud.fluid;
  published_pressure(f, 1225.0, 1000.0, 500.0);
  for (std::size_t i = 0; i < size_of(f); ++i) {
    EXPECT_EQ(f.pressure[i], 1225.0 * (f.density[i] - 1000.0) + 500.0);
    EXPECT_EQ(f.volume[i], f.mass[i] / f.density[i]);
  }
  f.density[3] = 990.0;  // spray or not
  published_pressure(f, 1225.0, 1000.0, 0.0);
  EXPECT_EQ(f.pressure[3], -12250.0);
}

TEST(AsPublished, EveryInstructionSetGivesTheSameBits) {
  const Cloud cloud;
  const auto n = size_of(cloud.fluid);
  std::vector<double> reference;
  for (const char* name : {"x86_64", "x86_64_v3", "x86_64_v4"}) {
    const PassTable* table = find_passes(name, Scheme::as_published);
    if (table == nullptr) continue;  // this machine cannot run it
    std::vector<double> all(8 * n, 0.0);
    double* p = all.data();
    table->pressure_force(cloud.arrays(), p, p + n, 0, cloud.fluid.n);
    table->viscous_force(cloud.arrays(), p + 2 * n, p + 3 * n, 0, cloud.fluid.n);
    table->density_rate(cloud.arrays(), {p + 4 * n, p + 5 * n, p + 6 * n, p + 7 * n}, 0,
                        cloud.fluid.n);
    if (reference.empty()) reference = all;
    EXPECT_EQ(all, reference) << name;
  }
  EXPECT_FALSE(reference.empty());
}

}  // namespace
}  // namespace parapet::solver
