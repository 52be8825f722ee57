// Scheme as_published beside a wall and at the surface, against plain double loops, and what its
// two integrations share.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "cloud.hpp"
#include "parapet/flow/as_published.hpp"
#include "parapet/flow/walls.hpp"

namespace parapet::solver {
namespace {

constexpr double dx = cloud_dx, h = cloud_h;

double harmonic(double a, double b) {
  return 2.0 * a * b / (a + b);
}

std::size_t size_of(const Fluid& f) {
  return static_cast<std::size_t>(f.n);
}

// A jittered pool on a flat bed: all that a particle is near it sees.
struct Pool {
  Flow flow;
  explicit Pool(WallSlip slip = WallSlip::no_slip, double shifting = 0.0)
      : flow(pool(slip, shifting)) {
    flow.evaluate();
  }

  static FlowSetup pool(WallSlip slip, double shifting) {
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

TEST(AsPublishedPool, WallPointsHaveTheInterpolatedPressureAndTheMirroredVelocity) {
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

TEST(AsPublishedPool, ForcesAtAWallAreEquation6WithItsPressureAndMirroredVelocity) {
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

TEST(AsPublishedPool, ShearRateIsThatOfThePlainGradientWithTheWallsVelocity) {
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
TEST(AsPublishedPool, ShiftAtTheSurfaceIsTangentialOrInwards) {
  Pool pool(WallSlip::no_slip, 1.0);
  ASSERT_FALSE(pool.flow.step(1e-7));  // looks at the speeds
  pool.flow.evaluate();
  const Fluid& f = pool.fluid();
  Fluid before = f;  // with the shift of Eq. 9 and 11 alone
  const ShiftingSettings settings{h, 1.2, 1.0, true, 0.0};
  finish_published_gradients(before, pool.flow.gradient_sums().view, settings, Material{}, 0, f.n);
  Fluid after = before;
  project_shift_at_surface(after, pool.flow.arrays(), 0, f.n);
  int spray = 0, projected = 0, inside = 0;
  for (std::size_t i = 0; i < size_of(f); ++i) {
    const Vec2 free{before.shift_u[i], before.shift_w[i]}, kept{after.shift_u[i], after.shift_w[i]};
    if (is_spray(before.lambda[i])) {
      EXPECT_EQ(norm(kept), 0.0);
      ++spray;
    } else if (before.lambda[i] > 0.9 / paper_lattice_sum) {
      EXPECT_EQ(norm(free - kept), 0.0);
      ++inside;
    } else {
      // what was taken away is along the normal and outwards, what is left is across it
      const Vec2 taken = free - kept;
      EXPECT_NEAR(dot(taken, kept), 0.0, 1e-12);
      projected += norm(taken) > 0.0;
      const double top = 0.08 - f.z[i], left = f.x[i], right = 0.12 - f.x[i];
      const bool middle = top < 1.5 * dx && left > 3.0 * dx && right > 3.0 * dx;
      if (middle && norm(taken) > 0.0) {
        EXPECT_GT(taken.z, 0.0);
      }
    }
  }
  EXPECT_GT(spray, 0);
  EXPECT_GT(projected, 10);
  EXPECT_GT(inside, 20);
}

TEST(AsPublishedPool, ImplicitViscosityIsTheExplicitForceForShortSteps) {
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

TEST(AsPublishedPool, MassesStayConstantWithBothIntegrations) {
  for (const Integrator integrator : {Integrator::implicit_viscosity, Integrator::rk4_explicit}) {
    FlowSetup setup = Pool::pool(WallSlip::no_slip, 1.0);
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
