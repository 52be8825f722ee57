// Retention, run-up and arrival on particles placed by hand.
#include "gauges/retention.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "placed_particles.hpp"

namespace parapet::solver {
namespace {

TEST(RetentionEfficiency, IsOneLessTheShareThatHasPassedTheLineOrLeft) {
  LevelChannel c;
  c.gauge.released_mass = 2.0;
  const Fluid f =
      fluid_of({{0.2, 0.1, 0.8}, {0.999, 0.3, 0.4}, {1.001, 0.0, 0.3}, {1.6, 0.0, 0.2}});
  // (0.3 + 0.2) kg/m stand beyond x = 1 m, 0.3 have left: 1 - 0.8/2
  EXPECT_DOUBLE_EQ(retention_efficiency(c.gauge, c.line(), f, 0.3), 0.6);
}

TEST(RetentionEfficiency, WhatStandsOnTheLineHasPassed) {
  LevelChannel c;
  EXPECT_DOUBLE_EQ(retention_efficiency(c.gauge, c.line(), fluid_of({{1.0, 0.1, 0.25}}), 0.0),
                   0.75);
}

TEST(RetentionEfficiency, IsOneToTheBitWhileNothingHasPassed) {
  LevelChannel c;
  std::vector<Placed> placed;
  for (int k = 0; k < 10; ++k) placed.push_back({0.05 * k, 0.0, 0.1});
  // ten times 0.1 do not add up to 1: summing what is upstream would give 0.9999999999999999
  EXPECT_EQ(retention_efficiency(c.gauge, c.line(), fluid_of(placed), 0.0), 1.0);
}

TEST(RetentionEfficiency, TheLineFollowsALeaningStemAboveItsCrest) {
  LevelChannel c;
  // leans upstream by 45 deg: at height z the line stands at x = 1 - z
  const double r = std::numbers::sqrt2 / 2.0;
  c.gauge.lines = {{{1.0, 0.0}, {r, r}}};
  const Fluid f =
      fluid_of({{0.85, 0.1, 0.1}, {0.85, 0.2, 0.3}, {0.45, 0.5, 0.2}, {0.45, 0.6, 0.4}});
  // beyond it: (0.85, 0.2) and (0.45, 0.6)
  EXPECT_NEAR(retention_efficiency(c.gauge, c.line(), f, 0.0), 1.0 - 0.7, 1e-15);
}

TEST(RunUpHeight, IsTheHeightThatAThousandthOfTheReleasedMassExceeds) {
  LevelChannel c;
  // from the top: 0.0004, 0.0008 (a thousandth is not yet reached), 0.0012 at z = 0.20
  const Fluid f = fluid_of(
      {{0.99, 0.10, 0.5}, {0.98, 0.20, 0.0004}, {0.97, 0.30, 0.0004}, {0.99, 0.25, 0.0004}});
  EXPECT_EQ(run_up_height(c.gauge, c.line(), f), 0.20);
}

TEST(RunUpHeight, LooksAtFortyMillimetresUpstreamOfTheLine) {
  LevelChannel c;
  const Fluid f = fluid_of({{0.959, 0.40, 0.1},    // 41 mm upstream
                            {0.961, 0.15, 0.1},    // 39 mm upstream
                            {1.000, 0.30, 0.1}});  // over the line
  EXPECT_EQ(run_up_height(c.gauge, c.line(), f), 0.15);
}

TEST(RunUpHeight, IsZeroWhileOnlyDropletsHaveArrived) {
  LevelChannel c;
  EXPECT_EQ(run_up_height(c.gauge, c.line(), fluid_of({{0.99, 0.30, 0.0009}})), 0.0);
  EXPECT_EQ(run_up_height(c.gauge, c.line(), fluid_of({})), 0.0);
}

TEST(RunUpHeight, DoesNotDependOnTheOrderOfTheParticles) {
  LevelChannel c;
  // two at one height, of which either alone is enough with the top one
  const std::vector<Placed> placed{
      {0.99, 0.30, 0.0002}, {0.98, 0.20, 0.0008}, {0.97, 0.20, 0.0001}, {0.99, 0.10, 0.9}};
  const std::vector<Placed> turned(placed.rbegin(), placed.rend());
  EXPECT_EQ(run_up_height(c.gauge, c.line(), fluid_of(placed)), 0.20);
  EXPECT_EQ(run_up_height(c.gauge, c.line(), fluid_of(turned)), 0.20);
}

TEST(MassShareAtLine, CountsTheTwentyMillimetresUpstreamOfTheLine) {
  LevelChannel c;
  c.gauge.released_mass = 4.0;
  const Fluid f = fluid_of({{0.979, 0.0, 0.5},    // 21 mm upstream
                            {0.981, 0.1, 0.3},    // 19 mm
                            {0.999, 0.2, 0.1},    // 1 mm
                            {1.000, 0.0, 0.7}});  // on the line
  EXPECT_DOUBLE_EQ(mass_share_at_line(c.gauge, c.line(), f), 0.1);
}

}  // namespace
}  // namespace parapet::solver
