// What barriers hold, as dead zone and as ramp, on particles placed by hand; windows of the flume.
#include "gauges/dead_zone.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "placed_particles.hpp"

namespace parapet::solver {
namespace {

constexpr double reach = 0.0133;  // 2h at 5 mm

// Bins of 20 mm. On a level bed the least depth is 20 mm: 1000 kg/m3 x 20 mm x 20 mm = 0.4 kg/m.
TEST(DeadZone, EndsInTheFirstBinThatIsNotDeepEnough) {
  LevelChannel c;
  const Fluid f = fluid_of({{0.995, 0.05, 0.3},    // first bin: 0.5 together
                            {0.985, 0.00, 0.2},    //
                            {0.975, 0.00, 0.41},   // second bin
                            {0.950, 0.00, 0.1},    // third bin: a quarter of what it needs
                            {0.930, 0.00, 5.0}});  // fourth bin, beyond the gap
  EXPECT_NEAR(dead_zone(c.gauge, 0, f).length, 0.045, 1e-15);
}

TEST(DeadZone, WhatMovesOrHasPassedIsNotPartOfIt) {
  LevelChannel c;
  Fluid f = fluid_of({{0.99, 0.0, 0.8, 0.0, 0.101}, {1.01, 0.0, 0.8}});
  EXPECT_EQ(dead_zone(c.gauge, 0, f).length, 0.0) << "0.101 m/s is not at rest";
  f = fluid_of({{0.99, 0.0, 0.8, 0.06, 0.07}, {1.01, 0.0, 0.8}});
  EXPECT_DOUBLE_EQ(dead_zone(c.gauge, 0, f).length, 0.02);
}

TEST(DeadZone, MustBeDeeperThanTheBedAloneCanHold) {
  LevelChannel c;
  c.scene.slope = std::numbers::pi / 6.0;  // sin = 1/2
  c.scene.gravity = 10.0;
  c.scene.material.yield_stress = 200.0;
  // 1.25 x 200 / (1000 x 10 x 0.5) = 50 mm, over 20 mm of the bed: 1.0 kg/m
  EXPECT_NEAR(dead_zone(c.gauge, 0, fluid_of({{0.99, 0.0, 0.75}})).length, 0.75 * 0.02, 1e-15);
  c.scene.material.yield_stress = 2000.0;  // 500 mm, of which no more than 100 mm are asked: 2 kg/m
  EXPECT_NEAR(dead_zone(c.gauge, 0, fluid_of({{0.99, 0.0, 0.5}})).length, 0.25 * 0.02, 1e-15);
}

TEST(DeadZone, ItsColumnsGrowWithTheEvent) {
  LevelChannel c;
  c.gauge.units = {0.4, 0.2, 2.0};  // bins and least depth of 40 mm need 1.6 kg/m
  const Fluid f = fluid_of({{0.98, 0.0, 1.61}, {0.95, 0.0, 0.8}});
  EXPECT_NEAR(dead_zone(c.gauge, 0, f).length, 0.04 * 1.5, 1e-15);
}

TEST(DeadZone, TheBedThatHoldsItIsTheOneBelow) {
  LevelChannel c;
  c.scene.material.yield_stress = 90.0;
  // a wedge that falls by 45 deg to the foot: a layer of 1.25 x 90/(1000 x 9.81 sin 45 deg) = 16 mm
  // rests on it, and 20 mm are asked at least; on 10 deg it is 66 mm
  c.scene.solids = {{{{0.5, 0.0}, {1.0, 0.0}, {0.5, 0.5 * std::tan(10.0 / 57.29577951308232)}}}};
  const double deep = 1.25 * 90.0 / (1000.0 * 9.81 * std::sin(10.0 / 57.29577951308232));
  const double full = 1000.0 * 0.02 * deep;
  EXPECT_NEAR(dead_zone(c.gauge, 0, fluid_of({{0.99, 0.02, 0.5 * full}})).length, 0.01, 1e-12);
}

TEST(DeadZone, ItsColumnsLeanWithTheStem) {
  LevelChannel c;
  // leans upstream: at height z the line stands at x = 1 - 3/4 z
  c.gauge.lines = {{{1.0, 0.0}, {0.8, 0.6}}};
  // 0.80 + 0.75 x 0.25 = 0.9875: first bin; at the same x on the bed it would be the eleventh
  EXPECT_DOUBLE_EQ(dead_zone(c.gauge, 0, fluid_of({{0.80, 0.25, 0.4}})).length, 0.02);
}

TEST(DeadZone, ItsAreaIsThatOfWhatRestsOverItsLength) {
  LevelChannel c;
  // a full column of 0.5 kg/m, one that is half as deep as wanted, and what lies beyond
  const Fluid f = fluid_of({{0.99, 0.0, 0.5}, {0.97, 0.0, 0.2}, {0.95, 0.0, 5.0}});
  const DeadZone zone = dead_zone(c.gauge, 0, f);
  EXPECT_NEAR(zone.length, 0.03, 1e-15);
  EXPECT_NEAR(zone.area, (0.5 + 0.5 * 0.2) / 1000.0, 1e-18);
}

TEST(DeadZone, EndsAtTheBarrierBefore) {
  LevelChannel c;
  c.gauge.lines.push_back({{1.05, 0.0}, {1.0, 0.0}});
  std::vector<Placed> placed{{1.04, 0.0, 0.5}, {1.02, 0.0, 0.5}, {1.005, 0.0, 0.5}};
  for (int k = 0; k < 10; ++k) placed.push_back({0.99 - 0.02 * k, 0.0, 0.5});
  const Fluid f = fluid_of(placed);
  EXPECT_NEAR(dead_zone(c.gauge, 0, f).length, 0.20, 1e-12);
  // 50 mm between the lines: three columns, the last one ends behind the line and counts as a whole
  EXPECT_NEAR(dead_zone(c.gauge, 1, f).area, 3.0 * 0.5 / 1000.0, 1e-12);
  EXPECT_NEAR(dead_zone(c.gauge, 1, f).length, 0.06, 1e-12);
}

/// A barrier normal to the bed at x = 1 m, 0.1 m high.
struct PileScene : LevelChannel {
  PileScene() {
    scene.barriers = {Barrier{}};
    gauge.edges = {{{1.0, 0.1}, {1.0, 0.0}}};
  }
};

/// Debris over x = 0.7 to 1.0 whose surface rises by 1 in 4.
std::vector<Placed> pile(double spacing) {
  std::vector<Placed> placed;
  for (double x = 0.7025; x < 0.999; x += spacing) {
    for (double z = 0.0; z <= 0.02 + 0.25 * (x - 0.7); z += spacing) placed.push_back({x, z, 0.01});
    placed.back().z = 0.02 + 0.25 * (x - 0.7);
  }
  return placed;
}

TEST(Ramp, IsTheSlopeOfTheFreeSurface) {
  PileScene s;
  std::vector<Placed> placed = pile(0.005);
  placed.push_back({0.9, 0.3, 0.01});  // a droplet above it
  const Ramp reading = ramp(s.gauge, 0, fluid_of(placed), reach);
  ASSERT_TRUE(reading.angle);
  // the highest particle of a column stands within 5 mm of its downstream end
  EXPECT_NEAR(*reading.angle, std::atan(0.25), 0.02);
}

TEST(Ramp, NeedsDebrisOverItsWholeLengthAndFourParticlesInAColumn) {
  PileScene s;
  std::vector<Placed> placed = pile(0.005);
  std::erase_if(placed, [](const Placed& p) { return p.x < 0.82; });  // from 0.80 on is wanted
  const Ramp gap = ramp(s.gauge, 0, fluid_of(placed), reach);
  EXPECT_FALSE(gap.angle);
  EXPECT_FALSE(gap.too_coarse);
  s.gauge.spacing = 0.0055;  // columns are 21.4 mm
  EXPECT_TRUE(ramp(s.gauge, 0, fluid_of(pile(0.005)), reach).too_coarse);
}

TEST(Ramp, OfASecondBarrierLooksNoFartherThanTheFirst) {
  PileScene s;
  s.scene.barriers.push_back(Barrier{});
  s.gauge.lines.push_back({{1.3, 0.0}, {1.0, 0.0}});
  s.gauge.edges.push_back({{1.3, 0.1}, {1.0, 0.0}});
  std::vector<Placed> placed = pile(0.005);
  for (const Placed& p : pile(0.005)) placed.push_back({p.x + 0.3, 2.0 * p.z, p.mass});
  const Fluid f = fluid_of(placed);
  const Ramp first = ramp(s.gauge, 0, f, reach), second = ramp(s.gauge, 1, f, reach);
  ASSERT_TRUE(first.angle && second.angle);
  EXPECT_NEAR(*first.angle, std::atan(0.25), 0.02);
  EXPECT_NEAR(*second.angle, std::atan(0.5), 0.04);  // what stands within 5 mm, twice as steep
  s.gauge.lines[1].foot.x = 1.3;
  s.gauge.lines[0].foot.x = 1.15;  // now its columns from 1.1 to 1.25 m begin behind the first
  EXPECT_FALSE(ramp(s.gauge, 1, f, reach).angle);
}

}  // namespace
}  // namespace parapet::solver
