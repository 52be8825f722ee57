// Herschel-Bulkley viscosity and the correction of the viscous sum.
#include "parapet/flow/rheology.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace parapet::solver {
namespace {

TEST(Rheology, TableOneCutOffViscosity) {
  // tau_y/0.1 + K 0.1^(N-1) = 900 + 4.526 * 0.1^-0.205 = 907.26 Pa s
  EXPECT_NEAR(apparent_viscosity(Material{}, 0.0), 907.26, 0.01);
  EXPECT_EQ(apparent_viscosity(Material{}, 0.05), apparent_viscosity(Material{}, 0.1));
}

TEST(Rheology, StressAboveTheCutOffIsHerschelBulkley) {
  const Material m;
  for (const double g : {0.2, 1.0, 30.0, 200.0}) {
    EXPECT_NEAR(apparent_viscosity(m, g) * g,
                m.yield_stress + m.consistency * std::pow(g, m.flow_index), 1e-9 * m.yield_stress);
  }
}

TEST(Rheology, NoYieldAndUnitIndexIsNewtonian) {
  Material water;
  water.yield_stress = 0.0;
  water.consistency = 0.001;
  water.flow_index = 1.0;
  EXPECT_EQ(apparent_viscosity(water, 0.0), 0.001);
  EXPECT_EQ(apparent_viscosity(water, 1e4), 0.001);
}

TEST(Rheology, APartOfTheYieldStressLeavesTheConsistencyAndTheCutOffAlone) {
  const Material m;
  const double g = 30.0, viscous = m.consistency * std::pow(g, m.flow_index);
  EXPECT_NEAR(apparent_viscosity(m, g, 0.6) * g, 0.6 * m.yield_stress + viscous,
              1e-9 * m.yield_stress);
  // what is at rest is as stiff as without a jump, down to 0.6 of the cut-off rate
  EXPECT_EQ(apparent_viscosity(m, 0.0, 0.6), apparent_viscosity(m, 0.0));
  EXPECT_NEAR(apparent_viscosity(m, 0.06, 0.6), apparent_viscosity(m, 0.06), 1e-9);
  EXPECT_LT(apparent_viscosity(m, 0.09, 0.6), 0.9 * apparent_viscosity(m, 0.09));
}

TEST(YieldFraction, IsTheShareOfTheGradientAtAJumpAndOneInASmoothFlow) {
  EXPECT_EQ(yield_fraction(100.0, 60.0, 0.0), 0.6);
  EXPECT_EQ(yield_fraction(100.0, 100.0, 0.0), 1.0);
  EXPECT_EQ(yield_fraction(100.0, 90.0, 0.0), 1.0);
  EXPECT_NEAR(yield_fraction(100.0, 81.0, 0.0), 0.81 + 0.5 * 0.19, 1e-12);  // halfway
  EXPECT_EQ(yield_fraction(100.0, 120.0, 0.0), 1.0);  // a support that is cut off
  EXPECT_EQ(yield_fraction(100.0, 10.0, 0.0), 0.5);   // modes that a gradient does not see
}

TEST(YieldFraction, GoesByTheGradientAloneBesideAWall) {
  EXPECT_EQ(yield_fraction(100.0, 90.0, 0.7), 0.9);
  EXPECT_EQ(yield_fraction(100.0, 90.0, 0.1), 0.9);
  EXPECT_NEAR(yield_fraction(100.0, 90.0, 0.05), 0.95, 1e-12);
}

TEST(YieldFraction, IsOneAtRest) {
  EXPECT_EQ(yield_fraction(0.0, 0.0, 0.0), 1.0);
}

TEST(Quadrature, IsOneForAnIsotropicCompleteNeighbourhood) {
  EXPECT_NEAR(viscous_quadrature(1.0, 0.0, 1.0, 0.0, 5.0), 1.0, 1e-12);
  EXPECT_NEAR(viscous_quadrature(1.0, 0.0, 1.0, 3.0, -4.0), 1.0, 1e-12);
}

TEST(Quadrature, MakesUpForRowsThatShearAlongEachOther) {
  // P = 1.16, Q = 0.84, a square lattice of h = 1.33 dx: simple shear (a = 0) sees Q alone,
  // extension (b = 0) sees P alone
  EXPECT_NEAR(viscous_quadrature(1.16, 0.0, 0.84, 0.0, 1.0), 1.0 / 0.84, 1e-9);
  EXPECT_NEAR(viscous_quadrature(1.16, 0.0, 0.84, 1.0, 0.0), 1.0 / 1.16, 1e-9);
}

TEST(Quadrature, DoesNotRefillACutOffSupport) {
  // half a neighbourhood, isotropic: the factor must stay near 0.5/0.99 x 2 = 1.01, not 2
  EXPECT_LT(viscous_quadrature(0.5, 0.0, 0.5, 0.0, 1.0), 1.05);
}

TEST(Quadrature, IsBoundedAndDefinedWithoutNeighbours) {
  EXPECT_EQ(viscous_quadrature(0.0, 0.0, 0.0, 1.0, 1.0), 1.0);
  EXPECT_LE(viscous_quadrature(2.0, 0.0, 1e-9, 0.0, 1.0), 2.0);
}

}  // namespace
}  // namespace parapet::solver
