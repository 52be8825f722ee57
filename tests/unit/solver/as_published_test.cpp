// Scheme as_published: every sum against the plain double loop of its equation, what the pair
// forces keep, and the instruction sets against each other.
#include "parapet/flow/as_published.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cloud.hpp"
#include "parapet/flow/walls.hpp"

namespace parapet::solver {
namespace {

constexpr double dx = cloud_dx, h = cloud_h;

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

// A jittered pool on a flat bed: all that a particle is near it sees.
struct Pool {
  Flow flow;
  explicit Pool(WallSlip slip = WallSlip::no_slip, double shifting = 0.0)
      : flow(setup(slip, shifting)) {
    flow.evaluate();
  }

  static FlowSetup setup(WallSlip slip, double shifting) {
    FlowSetup setup;
    setup.numerics.spacing = dx;
    setup.numerics.scheme = Scheme::as_published;
    setup.numerics.shifting_factor = shifting;
    setup.wall_slip = slip;
    setup.gravity = {0.5, -9.81};
    setup.particles = lattice_block(0.0, 0.0, 0.12, 0.08, dx, setup.material.density);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> offset(-0.2 * dx, 0.2 * dx), speed(-1.0, 1.0);
    for (InitialParticle& p : setup.particles) {
      p.x += offset(random);
      p.z += offset(random);
      p.u = speed(random);
      p.w = speed(random);
      p.density *= 1.0 + 0.01 * speed(random);
    }
    add_wall(setup, {-0.1, 0.0}, {0.22, 0.0});
    return setup;
  }

  const Fluid& fluid() const { return flow.fluid(); }

  // Calls body(r, W, F) for particle i or a place and another place within the support.
  template <class Body>
  static void visit(Vec2 from, Vec2 to, const Body& body) {
    const Kernel k = make_kernel(h, dx);
    const Vec2 r = from - to;
    const double q = norm(r) / h, t = 1.0 - 0.5 * q;
    if (t > 0.0) body(r, k.alpha * kernel_shape(q), -k.f_scale * t * t * t);
  }
};

Vec2 place(const Fluid& f, std::size_t i) {
  return {f.x[i], f.z[i]};
}

// Pressure and velocity of a wall point by Eq. 22, 23 and 27 of Adami et al. 2012.
struct OfWall {
  double pressure = 0.0;
  Vec2 velocity;
};
OfWall expected_at(const Flow& flow, std::size_t k) {
  const Fluid& f = flow.fluid();
  const WallPoints& walls = flow.walls();
  double w_sum = 0.0, p_sum = 0.0;
  Vec2 u_sum;
  for (std::size_t j = 0; j < size_of(f); ++j) {
    Pool::visit({walls.x[k], walls.z[k]}, place(f, j), [&](Vec2 r, double w, double) {
      w_sum += w;
      p_sum += w * (f.pressure[j] + f.density[j] * dot(flow.setup().gravity, r));
      u_sum = u_sum + w * Vec2{f.u[j], f.w[j]};
    });
  }
  if (w_sum == 0.0) return {};
  return {p_sum / w_sum, (-1.0 / w_sum) * u_sum};
}

TEST(AsPublished, WallPointsHaveTheInterpolatedPressureAndTheMirroredVelocity) {
  const Pool pool;
  const WallPoints& walls = pool.flow.walls();
  int negative = 0, seen = 0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const OfWall expected = expected_at(pool.flow, k);
    if (expected.velocity.x == 0.0) continue;
    ++seen;
    negative += expected.pressure < 0.0;
    EXPECT_NEAR(walls.pressure[k], expected.pressure, 1e-9 * std::abs(expected.pressure) + 1e-6);
    EXPECT_NEAR(walls.mirrored_u[k], expected.velocity.x, 1e-12);
    EXPECT_NEAR(walls.mirrored_w[k], expected.velocity.z, 1e-12);
  }
  EXPECT_GT(seen, 20);
  EXPECT_GT(negative, 0);  // here walls may pull
}

TEST(AsPublished, ForcesAtAWallAreEquation6WithItsPressureAndMirroredVelocity) {
  Pool pool;
  const Fluid& f = pool.fluid();
  const WallPoints& walls = pool.flow.walls();
  std::vector<double> ax(size_of(f) + 1, 0.0), az = ax;
  pool.flow.add_body_and_pressure_force(ax, az);
  pool.flow.add_viscous_force(ax, az);
  for (std::size_t i = 0; i < size_of(f); ++i) {
    Vec2 sum;
    const Vec2 u{f.u[i], f.w[i]};
    const auto add = [&](Vec2 r, double fv, double pressure, double eta, Vec2 other) {
      const double viscous = 8.0 * eta * dot(u - other, r) / dot(r, r);
      sum = sum + fv * (viscous - (pressure + f.tic[i] * f.pressure[i])) * r;
    };
    for (std::size_t j = 0; j < size_of(f); ++j) {
      if (j == i) continue;
      Pool::visit(place(f, i), place(f, j), [&](Vec2 r, double, double slope) {
        add(r, slope * f.volume[j], f.pressure[j], harmonic(f.viscosity[i], f.viscosity[j]),
            {f.u[j], f.w[j]});
      });
    }
    for (std::size_t k = 0; k < walls.size(); ++k) {
      Pool::visit(place(f, i), {walls.x[k], walls.z[k]}, [&](Vec2 r, double, double slope) {
        add(r, slope * walls.volume[k], walls.pressure[k], f.viscosity[i],
            {walls.mirrored_u[k], walls.mirrored_w[k]});
      });
    }
    const Vec2 expected = (1.0 / f.density[i]) * sum + pool.flow.setup().gravity;
    EXPECT_NEAR(ax[i], expected.x, 1e-8 * norm(expected));
    EXPECT_NEAR(az[i], expected.z, 1e-8 * norm(expected));
  }
}

TEST(AsPublished, ShearRateIsThatOfThePlainGradientWithTheWallsVelocity) {
  const Pool pool;
  const Fluid& f = pool.fluid();
  const WallPoints& walls = pool.flow.walls();
  for (std::size_t i = 0; i < size_of(f); ++i) {
    double ux = 0.0, uz = 0.0, wx = 0.0, wz = 0.0;
    const auto add = [&](Vec2 grad, double u, double w) {
      ux += (u - f.u[i]) * grad.x;
      uz += (u - f.u[i]) * grad.z;
      wx += (w - f.w[i]) * grad.x;
      wz += (w - f.w[i]) * grad.z;
    };
    for (std::size_t j = 0; j < size_of(f); ++j) {
      Pool::visit(place(f, i), place(f, j), [&](Vec2 r, double, double slope) {
        add(slope * f.volume[j] * r, f.u[j], f.w[j]);
      });
    }
    for (std::size_t k = 0; k < walls.size(); ++k) {
      Pool::visit(place(f, i), {walls.x[k], walls.z[k]}, [&](Vec2 r, double, double slope) {
        add(slope * walls.volume[k] * r, walls.mirrored_u[k], walls.mirrored_w[k]);
      });
    }
    const double expected = std::sqrt(2.0 * (ux * ux + wz * wz) + (uz + wx) * (uz + wx));
    EXPECT_NEAR(f.shear_rate[i], expected, 1e-9 * expected);
  }
}

// Eq. 10: nothing comes of Eq. 9 and 11 where lambda < 0.55; up to 0.9 nothing out of the fluid.
TEST(AsPublished, ShiftAtTheSurfaceIsTangentialOrInwards) {
  Pool pool(WallSlip::no_slip, 1.0);
  ASSERT_FALSE(pool.flow.step(1e-7));  // looks at the speeds
  pool.flow.evaluate();
  const Fluid& f = pool.fluid();
  const FlowArrays arrays = pool.flow.arrays();
  Fluid before = f;  // with the shift of Eq. 9 and 11 alone
  const ShiftingSettings settings{h, 1.2, 1.0, true, 0.0};
  finish_published_gradients(before, pool.flow.gradient_sums().view, settings, Material{}, 0, f.n);
  Fluid after = before;
  project_shift_at_surface(after, arrays, 0, f.n);
  int spray = 0, projected = 0, inwards = 0, inside = 0;
  for (std::size_t i = 0; i < size_of(f); ++i) {
    const Vec2 free{before.shift_u[i], before.shift_w[i]}, kept{after.shift_u[i], after.shift_w[i]};
    if (f.lambda[i] < 0.55) {
      EXPECT_EQ(norm(kept), 0.0);
      ++spray;
    } else if (f.lambda[i] > 0.9) {
      EXPECT_EQ(norm(free - kept), 0.0);
      ++inside;
    } else {
      // what was taken away is along the normal and outwards, what is left is across it
      const Vec2 taken = free - kept;
      EXPECT_NEAR(dot(taken, kept), 0.0, 1e-12);
      projected += norm(taken) > 0.0;
      inwards += norm(taken) == 0.0;
      const double top = 0.08 - f.z[i], left = f.x[i], right = 0.12 - f.x[i];
      const bool middle = top < 1.5 * dx && left > 3.0 * dx && right > 3.0 * dx;
      if (middle && norm(taken) > 0.0) EXPECT_GT(taken.z, std::abs(taken.x));
    }
  }
  EXPECT_GT(spray, 3);
  EXPECT_GT(projected, 10);
  EXPECT_GT(inside, 20);
}

TEST(AsPublished, ImplicitViscosityIsTheExplicitForceForShortSteps) {
  Pool pool;
  const Fluid& f = pool.fluid();
  std::vector<double> ax(size_of(f) + 1, 0.0), az = ax;
  pool.flow.add_viscous_force(ax, az);
  const std::vector<double> u0 = f.u, w0 = f.w;
  std::vector<double> u = u0, w = w0;
  constexpr double dt = 1e-9;  // [s]
  ASSERT_TRUE(pool.flow.solve_viscosity(u0, w0, u, w, dt));
  double worst = 0.0, size = 0.0;
  for (std::size_t i = 0; i < size_of(f); ++i) {
    worst = std::max(
        {worst, std::abs((u[i] - u0[i]) / dt - ax[i]), std::abs((w[i] - w0[i]) / dt - az[i])});
    size = std::max({size, std::abs(ax[i]), std::abs(az[i])});
  }
  // the tolerance of the solve is 0.5 m/s2, the matrix is kept in floats (6e-8)
  EXPECT_LT(worst, 0.5 + 1e-3 * size);
  EXPECT_GT(size, 100.0);
}

TEST(AsPublished, MassesStayConstantWithBothIntegrations) {
  for (const Integrator integrator : {Integrator::implicit_viscosity, Integrator::rk4_explicit}) {
    FlowSetup setup = Pool::setup(WallSlip::no_slip, 1.0);
    setup.numerics.integrator = integrator;
    const double mass = setup.particles.front().mass;
    Flow flow(std::move(setup));
    for (int step = 0; step < 3; ++step) ASSERT_FALSE(flow.step(1e-5));
    const Fluid& f = static_cast<const Flow&>(flow).fluid();
    for (std::size_t i = 0; i < size_of(f); ++i) EXPECT_EQ(f.mass[i], mass);
  }
}

}  // namespace
}  // namespace parapet::solver
