// The overflow's tongue at one instant, on particles placed by hand.
#include "gauges/instant.hpp"

#include <gtest/gtest.h>

#include "gauges/connected.hpp"
#include "placed_particles.hpp"

namespace parapet::solver {
namespace {

constexpr double reach = 0.0133;  // 2h at 5 mm

TEST(MainBody, IsTheHeaviestOfThoseThatHangTogether) {
  const std::vector<Vec2> places{{0.0, 0.0},  {1.0, 0.0},  {0.01, 0.0},
                                 {1.01, 0.0}, {1.02, 0.0}, {0.02, 0.01}};
  const std::vector<double> masses{1.0, 1.0, 1.0, 1.0, 1.0, 0.5};
  EXPECT_EQ(main_body(places, masses, 0.0101), (std::vector<std::size_t>{1, 3, 4}));
  EXPECT_EQ(main_body(places, masses, 0.02).size(), 3U);
  EXPECT_EQ(main_body(places, masses, 2.0).size(), 6U) << "all of them";
  EXPECT_TRUE(main_body({}, {}, 0.01).empty());
}

TEST(MainBody, IsTheSameForAnyOrderAndNegativePlaces) {
  std::vector<Vec2> places;
  for (int k = -20; k < 20; ++k) places.push_back({0.01 * ((k * 7) % 20), -0.003 * (k % 2)});
  const std::vector<double> masses(places.size(), 1.0);
  EXPECT_EQ(main_body(places, masses, 0.011).size(), places.size());
}

/// A barrier normal to the bed at x = 1 m, 0.1 m high.
struct InstantScene : LevelChannel {
  InstantScene() {
    scene.barriers = {Barrier{}};
    gauge.edges = {{{1.0, 0.1}, {1.0, 0.0}}};
  }
};

TEST(Tongue, EndsWhereTheConnectedFluidEnds) {
  InstantScene s;
  std::vector<Placed> placed;
  for (int k = 0; k < 60; ++k) placed.push_back({1.0 + 0.01 * k, 0.1, 0.01});
  placed.push_back({1.65, 0.1, 0.01});  // 60 mm ahead: a droplet
  placed.push_back({0.99, 0.1, 0.50});  // upstream of the line
  const InstantReadings air = read_instant(s.gauge, fluid_of(placed), reach);
  ASSERT_TRUE(air.tongue);
  EXPECT_DOUBLE_EQ(air.tongue->tip_x, 1.59);
  EXPECT_DOUBLE_EQ(air.tongue->farthest_x, 1.65);
  EXPECT_FALSE(air.tongue->landed);
  placed[60].x = 2.0;    // far away
  placed[40].z = 0.005;  // 190 mm behind the tip
  EXPECT_FALSE(read_instant(s.gauge, fluid_of(placed), 0.12).tongue->landed);
  placed[59].z = 0.005;
  EXPECT_TRUE(read_instant(s.gauge, fluid_of(placed), 0.12).tongue->landed);
}

TEST(Tongue, IsAbsentWhenNothingHasPassed) {
  InstantScene s;
  EXPECT_FALSE(read_instant(s.gauge, fluid_of({{0.99, 0.0, 1.0}}), reach).tongue);
  s.gauge.lines.clear();
  EXPECT_FALSE(read_instant(s.gauge, fluid_of({{1.2, 0.0, 1.0}}), reach).tongue);
}

}  // namespace
}  // namespace parapet::solver
