// Front, depth and kinetic energy on particles placed by hand; windows of the flume.
#include "gauges/channel_gauge.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace parapet::solver
