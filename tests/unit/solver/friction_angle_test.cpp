// The yield stress c + p tan(phi): in the viscosity, and in the slope at which a layer stops.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "parapet/flow/flow.hpp"
#include "parapet/flow/rheology.hpp"
#include "parapet/flow/walls.hpp"

namespace parapet::solver {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

TEST(FrictionAngle, AddsThePressureTimesItsTangentAndNothingUnderTension) {
  Material m;
  m.friction_angle = 30.0 * degree;
  const double tan_phi = std::tan(m.friction_angle);
  EXPECT_NEAR(yield_stress_under(m, tan_phi, 1000.0), 90.0 + 1000.0 * tan_phi, 1e-9);
  EXPECT_EQ(yield_stress_under(m, tan_phi, -1000.0), 90.0);
  const double g = 20.0, yield = yield_stress_under(m, tan_phi, 1000.0);
  EXPECT_NEAR(apparent_viscosity(m, yield, g, 1.0) * g,
              yield + m.consistency * std::pow(g, m.flow_index), 1e-9 * yield);
}

TEST(FrictionAngle, ZeroIsTheMaterialWithout) {
  const Material m;
  for (const double g : {0.0, 0.3, 40.0}) {
    EXPECT_EQ(apparent_viscosity(m, yield_stress_under(m, std::tan(m.friction_angle), 5e3), g, 0.7),
              apparent_viscosity(m, g, 0.7));
  }
}

// Mean speed of a layer that is uniform down the slope, over that of its creep at the slope where
// it yields (tan slope = tan phi), which without cohesion is g_c z.
double speed_over_creep(double slope, Scheme scheme) {
  constexpr double depth = 0.04, dx = depth / 8.0, length = 12.0 * dx;
  FlowSetup setup;
  setup.numerics.spacing = dx;
  setup.numerics.sound_speed = 10.0;
  setup.numerics.scheme = scheme;
  setup.numerics.cg_tolerance = 1e-3;
  setup.material.yield_stress = 0.0;
  setup.material.consistency = 1.0;
  setup.material.flow_index = 1.0;
  setup.material.friction_angle = 20.0 * degree;
  setup.gravity = {9.81 * std::sin(slope), -9.81 * std::cos(slope)};
  setup.periodic_length = length;
  add_periodic_wall(setup, length, 0.0, true);
  setup.particles = lattice_block(0.0, 0.0, length, depth, dx, setup.material.density);
  for (InitialParticle& p : setup.particles) {
    p.density -= setup.material.density * setup.gravity.z * (depth - p.z) / 100.0;
  }
  Flow flow(std::move(setup));
  while (flow.time() < 0.3) {
    if (flow.step(0.3 - flow.time())) return -1.0;
  }
  const Fluid& f = static_cast<const Flow&>(flow).fluid();
  double momentum = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    momentum += f.mass[i] * f.u[i];
    mass += f.mass[i];
  }
  return momentum / mass / (0.5 * depth * flow.setup().material.cutoff_shear_rate);
}

// Below the angle of friction the viscoplastic regularisation creeps, at g_c tan(slope)/tan(phi);
// above it flows as a Bingham fluid, here 30 times as fast at 2 deg more.
TEST(FrictionAngle, ALayerStopsBelowItAndFlowsAboveIt) {
  const double below = speed_over_creep(18.5 * degree, Scheme::corrected);
  // 2 %: as far as the finer layer is off below its slope (docs/validation/frictional_layer.md)
  EXPECT_NEAR(below, std::tan(18.5 * degree) / std::tan(20.0 * degree), 0.02);
  EXPECT_GT(speed_over_creep(21.5 * degree, Scheme::corrected), 5.0);
}

// The paper's sums resist less than tau_y: the layer flows from about 18 deg on
// (docs/validation/frictional_layer.md).
TEST(FrictionAngle, AsPublishedTheLayerStopsSomewhatBelowIt) {
  EXPECT_LT(speed_over_creep(16.0 * degree, Scheme::as_published), 1.0);
  EXPECT_GT(speed_over_creep(21.5 * degree, Scheme::as_published), 5.0);
}

}  // namespace
}  // namespace parapet::solver
