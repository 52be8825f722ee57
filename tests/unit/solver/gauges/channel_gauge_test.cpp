// Front, depth, kinetic energy and dead zone on particles placed by hand; windows of the flume.
#include "gauges/channel_gauge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "placed_particles.hpp"

namespace parapet::solver {
namespace {

TEST(FrontPosition, HasHalfAPercentOfTheReleasedMassAhead) {
  LevelChannel c;
  // from the front: 0.002, 0.004, 0.006: half a percent is reached at x = 0.70
  const Fluid f =
      fluid_of({{0.50, 0.0, 0.9}, {0.70, 0.0, 0.002}, {0.90, 0.0, 0.002}, {0.80, 0.3, 0.002}});
  EXPECT_EQ(front_position(c.gauge, f, 0.0), 0.70);
}

TEST(FrontPosition, WhatHasLeftIsAheadOfEverything) {
  LevelChannel c;
  c.scene.domain_length = 2.5;
  const Fluid f = fluid_of({{0.70, 0.0, 0.9}, {0.90, 0.0, 0.002}});
  EXPECT_EQ(front_position(c.gauge, f, 0.004), 0.90);  // 0.004 + 0.002
  EXPECT_EQ(front_position(c.gauge, f, 0.005), 2.5) << "the outlet";
}

TEST(FrontPosition, IsFoundAmongManyParticlesWhateverTheirOrder) {
  LevelChannel c;
  c.gauge.released_mass = 400.0;
  std::vector<Placed> placed;
  // 400 of 1 kg/m at x = 0, 0.01, ... 3.99; half a percent is two of them
  for (int k = 0; k < 400; ++k) placed.push_back({0.01 * ((k * 37) % 400), 0.0, 1.0});
  EXPECT_DOUBLE_EQ(front_position(c.gauge, fluid_of(placed), 0.0), 3.98);
  // of 40000 kg/m it is two hundred: the 200th from the front
  c.gauge.released_mass = 40000.0;
  EXPECT_DOUBLE_EQ(front_position(c.gauge, fluid_of(placed), 0.0), 2.00);
}

TEST(FrontPosition, IsTheBackWallWhenTooLittleIsLeft) {
  LevelChannel c;
  EXPECT_EQ(front_position(c.gauge, fluid_of({{0.9, 0.0, 0.004}}), 0.0), 0.0);
}

TEST(FlowDepth, IsTheVolumeInFortyMillimetresOverTheirLength) {
  LevelChannel c;
  const Fluid f = fluid_of({{0.959, 0.0, 5.0},    // 41 mm upstream
                            {0.961, 0.0, 0.5},    // 39 mm
                            {1.000, 0.1, 0.3},    // at the gauge
                            {1.001, 0.0, 5.0}});  // beyond
  // 0.8 kg/m / (1000 kg/m3 x 0.04 m)
  EXPECT_DOUBLE_EQ(flow_depth(c.gauge, f), 0.02);
}

TEST(KineticEnergy, OfTheWindowCountsFiftyMillimetresOnEitherSide) {
  LevelChannel c;
  const Fluid f = fluid_of({{0.949, 0.0, 1.0, 10.0, 0.0},
                            {0.951, 0.0, 2.0, 3.0, 4.0},   // 0.5 x 2 x 25
                            {1.049, 0.2, 4.0, 0.0, -1.0},  // 0.5 x 4 x 1
                            {1.051, 0.0, 1.0, -2.0, 0.0}});
  EXPECT_DOUBLE_EQ(window_kinetic_energy(c.gauge, f), 27.0);
  EXPECT_DOUBLE_EQ(total_kinetic_energy(f), 50.0 + 27.0 + 2.0);
}

// Bins of 20 mm. On a level bed the least depth is 20 mm: 1000 kg/m3 x 20 mm x 20 mm = 0.4 kg/m.
TEST(DeadZone, EndsInTheFirstBinThatIsNotDeepEnough) {
  LevelChannel c;
  const Fluid f = fluid_of({{0.995, 0.05, 0.3},    // first bin: 0.5 together
                            {0.985, 0.00, 0.2},    //
                            {0.975, 0.00, 0.41},   // second bin
                            {0.950, 0.00, 0.1},    // third bin: a quarter of what it needs
                            {0.930, 0.00, 5.0}});  // fourth bin, beyond the gap
  EXPECT_NEAR(dead_zone_length(c.gauge, f), 0.045, 1e-15);
}

TEST(DeadZone, WhatMovesOrHasPassedIsNotPartOfIt) {
  LevelChannel c;
  Fluid f = fluid_of({{0.99, 0.0, 0.8, 0.0, 0.101}, {1.01, 0.0, 0.8}});
  EXPECT_EQ(dead_zone_length(c.gauge, f), 0.0) << "0.101 m/s is not at rest";
  f = fluid_of({{0.99, 0.0, 0.8, 0.06, 0.07}, {1.01, 0.0, 0.8}});
  EXPECT_DOUBLE_EQ(dead_zone_length(c.gauge, f), 0.02);
}

TEST(DeadZone, MustBeDeeperThanTheBedAloneCanHold) {
  LevelChannel c;
  c.scene.slope = std::numbers::pi / 6.0;  // sin = 1/2
  c.scene.gravity = 10.0;
  c.scene.material.yield_stress = 200.0;
  // 1.25 x 200 / (1000 x 10 x 0.5) = 50 mm, over 20 mm of the bed: 1.0 kg/m
  EXPECT_NEAR(dead_zone_length(c.gauge, fluid_of({{0.99, 0.0, 0.75}})), 0.75 * 0.02, 1e-15);
  c.scene.material.yield_stress = 2000.0;  // 500 mm, of which no more than 100 mm are asked: 2 kg/m
  EXPECT_NEAR(dead_zone_length(c.gauge, fluid_of({{0.99, 0.0, 0.5}})), 0.25 * 0.02, 1e-15);
}

TEST(DeadZone, ItsColumnsGrowWithTheEvent) {
  LevelChannel c;
  c.gauge.units = {0.4, 0.2, 2.0};  // bins and least depth of 40 mm need 1.6 kg/m
  const Fluid f = fluid_of({{0.98, 0.0, 1.61}, {0.95, 0.0, 0.8}});
  EXPECT_NEAR(dead_zone_length(c.gauge, f), 0.04 * 1.5, 1e-15);
}

TEST(DeadZone, TheBedThatHoldsItIsTheOneBelow) {
  LevelChannel c;
  c.scene.material.yield_stress = 90.0;
  // a wedge that falls by 45 deg to the foot: a layer of 1.25 x 90/(1000 x 9.81 sin 45 deg) = 16 mm
  // rests on it, and 20 mm are asked at least; on 10 deg it is 66 mm
  c.scene.solids = {{{{0.5, 0.0}, {1.0, 0.0}, {0.5, 0.5 * std::tan(10.0 / 57.29577951308232)}}}};
  const double deep = 1.25 * 90.0 / (1000.0 * 9.81 * std::sin(10.0 / 57.29577951308232));
  const double full = 1000.0 * 0.02 * deep;
  EXPECT_NEAR(dead_zone_length(c.gauge, fluid_of({{0.99, 0.02, 0.5 * full}})), 0.01, 1e-12);
}

TEST(DeadZone, ItsColumnsLeanWithTheStem) {
  LevelChannel c;
  // leans upstream: at height z the line stands at x = 1 - 3/4 z
  c.gauge.lines = {{{1.0, 0.0}, {0.8, 0.6}}};
  // 0.80 + 0.75 x 0.25 = 0.9875: first bin; at the same x on the bed it would be the eleventh
  EXPECT_DOUBLE_EQ(dead_zone_length(c.gauge, fluid_of({{0.80, 0.25, 0.4}})), 0.02);
}

TEST(DeadZone, AnOpenChannelHasNone) {
  LevelChannel c;
  c.gauge.lines.clear();
  EXPECT_EQ(dead_zone_length(c.gauge, fluid_of({{0.99, 0.0, 5.0}})), 0.0);
}

}  // namespace
}  // namespace parapet::solver
