// The gauge of the overflow on a particle moved by hand.
#include "gauges/launch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "placed_particles.hpp"

namespace parapet::solver {
namespace {

// A deflector's tip at (0.95, 0.15).
struct OverflowScene : LevelChannel {
  OverflowScene() { gauge.edges = {{{0.95, 0.15}, {1.0, 0.0}}}; }
};

Fluid one_particle(double mass) {
  return fluid_of({{0.0, 0.2, mass}});
}

void put(Fluid& f, double x, double z, double u, double w) {
  f.x[0] = x;
  f.z[0] = z;
  f.u[0] = u;
  f.w[0] = w;
}

TEST(LaunchGauge, ReadsTheDirectionAtTheEdgeAndThePlaceOfLanding) {
  OverflowScene s;
  LaunchGauge gauge(s.gauge);
  Fluid f = one_particle(0.02);
  put(f, 0.90, 0.18, 1.0, 1.0);
  gauge.observe(f, 0.0);
  EXPECT_FALSE(gauge.impact());
  put(f, 0.96, 0.20, 1.0, 0.5);  // the passage
  gauge.observe(f, 0.1);
  put(f, 1.20, 0.015, 1.0, -2.0);
  gauge.observe(f, 0.2);
  EXPECT_FALSE(gauge.launch()) << "nothing has landed yet";
  put(f, 1.25, 0.005, 1.0, -2.5);
  gauge.observe(f, 0.3);
  ASSERT_TRUE(gauge.impact() && gauge.launch());
  EXPECT_DOUBLE_EQ(gauge.impact()->x, 1.25);
  EXPECT_DOUBLE_EQ(gauge.impact()->time, 0.3);
  EXPECT_DOUBLE_EQ(gauge.impact()->landing_speed, std::hypot(1.0, 2.0));
  EXPECT_DOUBLE_EQ(gauge.launch()->angle, std::atan2(0.5, 1.0));
  EXPECT_DOUBLE_EQ(gauge.launch()->height, 0.20);
}

TEST(LaunchGauge, TheLandingIsOverWhenTheFirstPerCentIsDownOrTooLittleIsInTheAir) {
  OverflowScene s;
  s.scene.barriers = {Barrier{}};  // a fall from its crest ends at about 1 m/s
  LaunchGauge gauge(s.gauge);
  Fluid f = fluid_of({{0.9, 0.18, 0.006}, {0.9, 0.18, 0.006}});
  EXPECT_FALSE(gauge.landing(f)) << "before the first step";
  gauge.observe(f, 0.0);
  EXPECT_FALSE(gauge.landing(f)) << "still upstream";
  put(f, 1.2, 0.1, 1.0, -1.0);
  gauge.observe(f, 0.1);
  EXPECT_TRUE(gauge.landing(f)) << "0.6 % in the air will be an impact";
  put(f, 1.2, 0.1, 0.01, 0.0);
  EXPECT_FALSE(gauge.landing(f)) << "it lies on the crest";
  put(f, 1.3, 0.005, 1.0, -2.0);
  gauge.observe(f, 0.2);
  EXPECT_FALSE(gauge.landing(f)) << "nothing is in the air";
  f.x[1] = 1.1;
  f.w[1] = -1.0;
  EXPECT_TRUE(gauge.landing(f)) << "the first 1 % are not complete";
  f.x[1] = 1.35;
  f.z[1] = 0.004;
  gauge.observe(f, 0.3);
  EXPECT_FALSE(gauge.landing(f));
}

TEST(LaunchGauge, TooLittleInTheAirToBeAnImpact) {
  OverflowScene s;
  s.scene.barriers = {Barrier{}};
  LaunchGauge gauge(s.gauge);
  Fluid f = one_particle(0.004);
  put(f, 1.2, 0.1, 1.0, -1.0);
  gauge.observe(f, 0.1);
  EXPECT_FALSE(gauge.landing(f));
}

TEST(LaunchGauge, WhatLiesInThePocketBelowThePlateHasNotPassedTheEdge) {
  OverflowScene s;
  LaunchGauge gauge(s.gauge);
  Fluid f = one_particle(0.02);
  put(f, 0.97, 0.05, 0.3, 0.0);  // under the plate
  gauge.observe(f, 0.1);
  put(f, 0.94, 0.16, -0.2, 1.0);  // out again and up
  gauge.observe(f, 0.2);
  put(f, 0.96, 0.17, 1.0, 1.0);  // over the tip
  gauge.observe(f, 0.3);
  put(f, 1.10, 0.005, 1.0, -1.0);
  gauge.observe(f, 0.4);
  ASSERT_TRUE(gauge.launch());
  EXPECT_DOUBLE_EQ(gauge.launch()->angle, std::numbers::pi / 4.0);
}

TEST(LaunchGauge, LandsOnWhateverBedIsBelow) {
  OverflowScene s;
  // a step of 0.1 m downstream of the barrier
  s.scene.solids = {{{{1.1, 0.0}, {2.0, 0.0}, {2.0, 0.1}, {1.1, 0.1}}}};
  LaunchGauge gauge(s.gauge);
  Fluid f = one_particle(0.02);
  put(f, 0.96, 0.20, 1.0, 0.5);
  gauge.observe(f, 0.1);
  put(f, 1.05, 0.105, 1.0, -1.0);
  gauge.observe(f, 0.2);
  EXPECT_FALSE(gauge.impact()) << "before the step";
  put(f, 1.20, 0.105, 1.0, -2.0);
  gauge.observe(f, 0.3);
  ASSERT_TRUE(gauge.impact());
  EXPECT_DOUBLE_EQ(gauge.impact()->x, 1.20);
  EXPECT_DOUBLE_EQ(gauge.impact()->landing_speed, std::hypot(1.0, 2.0));
}

TEST(LaunchGauge, DropletsDoNotDecide) {
  OverflowScene s;
  LaunchGauge gauge(s.gauge);
  Fluid f = one_particle(0.004);  // below 0.5 % of the released mass
  put(f, 1.10, 0.005, 1.0, -1.0);
  gauge.observe(f, 0.1);
  EXPECT_FALSE(gauge.impact());
}

// Three particles of 0.01 kg/m pass within 20 ms at 0.5 m/s, one long after: 0.03/1000 m2 in 20 ms
// is a discharge of 1.5e-3 m2/s, and at 0.5 m/s a sheet of 3 mm.
TEST(LaunchGauge, TheSheetIsItsLargestDischargeOverItsSpeed) {
  OverflowScene s;
  LaunchGauge gauge(s.gauge);
  Fluid f = fluid_of({{0.9, 0.2, 0.01, 0.3, 0.4},
                      {0.9, 0.2, 0.01, 0.3, 0.4},
                      {0.9, 0.2, 0.01, 0.3, 0.4},
                      {0.9, 0.2, 0.01, 2.0, 0.0}});
  EXPECT_FALSE(gauge.sheet());
  const double window = s.gauge.time(s.gauge.settings.discharge_time_ratio);
  gauge.observe(f, 0.0);
  for (int k = 0; k < 3; ++k) {
    f.x[static_cast<std::size_t>(k)] = 0.96;
    gauge.observe(f, 0.1 + 0.3 * window * k);
  }
  f.x[3] = 0.96;
  gauge.observe(f, 0.5);
  ASSERT_TRUE(gauge.sheet());
  EXPECT_NEAR(gauge.sheet()->speed, 0.5, 1e-15);
  EXPECT_NEAR(gauge.sheet()->thickness, 0.03 / 1000.0 / window / 0.5, 1e-15);
}

TEST(LaunchGauge, ASheetNeedsHalfAPercentOfTheMassOverTheEdge) {
  OverflowScene s;
  LaunchGauge gauge(s.gauge);
  Fluid f = one_particle(0.004);
  put(f, 0.96, 0.2, 1.0, 0.0);
  gauge.observe(f, 0.1);
  EXPECT_FALSE(gauge.sheet());
}

}  // namespace
}  // namespace parapet::solver
