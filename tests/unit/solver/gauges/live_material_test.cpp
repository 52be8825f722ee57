// Which material can still change a metric: particles placed by hand.
#include "gauges/live_material.hpp"

#include <gtest/gtest.h>

#include "placed_particles.hpp"

namespace parapet::solver {
namespace {

TEST(LiveMaterial, WhatHasPassedTheLastLineHasNoEnergyLeftToGive) {
  LevelChannel s;
  const Fluid fluid = fluid_of({{0.5, 0.01, 0.40, 0.2, 0.0}, {1.5, 0.01, 0.40, 3.0, 0.0}});
  EXPECT_DOUBLE_EQ(live_energy(s.gauge, fluid, 0.005), 0.5 * 0.4 * 0.04);
}

TEST(LiveMaterial, BetweenTwoBarriersItCanStillLoadTheSecond) {
  LevelChannel s;
  s.gauge.lines.push_back({{1.7, 0.0}, {1.0, 0.0}});
  const Fluid fluid = fluid_of({{1.5, 0.01, 0.20, 1.0, 0.0}, {1.8, 0.01, 0.20, 1.0, 0.0}});
  EXPECT_DOUBLE_EQ(live_energy(s.gauge, fluid, 0.005), 0.5 * 0.2);
}

TEST(LiveMaterial, AnOpenChannelsGaugeEndsBeyondItsWindow) {
  LevelChannel s;
  s.gauge.lines.clear();
  const Fluid fluid = fluid_of({{1.04, 0.01, 0.20, 1.0, 0.0}, {1.06, 0.01, 0.20, 1.0, 0.0}});
  EXPECT_DOUBLE_EQ(live_energy(s.gauge, fluid, 0.005), 0.5 * 0.2) << "1.06 m is past the gauge";
}

TEST(LiveMaterial, StraysDecideNothingAndAFlowDoes) {
  LevelChannel s;
  std::vector<Placed> placed;
  for (int k = 0; k < 4; ++k) placed.push_back({0.2 + 0.01 * k, 0.01, 0.001, 2.0, 0.0});
  placed.push_back({0.8, 0.02, 0.5});  // at rest
  EXPECT_EQ(live_energy(s.gauge, fluid_of(placed), 0.005), 0.0) << "0.4 % of the released mass";
  for (int k = 0; k < 10; ++k) placed.push_back({0.4 + 0.01 * k, 0.01, 0.002, 1.0, 0.0});
  EXPECT_NEAR(live_energy(s.gauge, fluid_of(placed), 0.005), 0.5 * 0.020, 1e-15);
}

TEST(LiveMaterial, SlowThickDebrisIsWaitedForAsLongAsItMayArrive) {
  LevelChannel s;
  // 30 % of the mass creeps at 20 mm/s, half a metre before the line: there in 25 s
  const Fluid creeping = fluid_of({{0.5, 0.05, 0.3, 0.02, 0.0}, {0.1, 0.05, 0.7}});
  EXPECT_TRUE(may_still_arrive(s.gauge, s.line(), creeping, 30.0));
  EXPECT_FALSE(may_still_arrive(s.gauge, s.line(), creeping, 20.0)) << "the run ends before";
  const Fluid stray = fluid_of({{0.5, 0.05, 0.004, 1.0, 0.0}, {0.1, 0.05, 0.7}});
  EXPECT_FALSE(may_still_arrive(s.gauge, s.line(), stray, 30.0)) << "0.4 % arrive nowhere";
  const Fluid gone = fluid_of({{1.2, 0.05, 0.3, 1.0, 0.0}});
  EXPECT_FALSE(may_still_arrive(s.gauge, s.line(), gone, 30.0)) << "it has passed";
}

}  // namespace
}  // namespace parapet::solver
