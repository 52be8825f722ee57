// Debris thrown back by a barrier, on particles placed by hand; at rest is slower than 0.1 m/s.
#include "gauges/backflow.hpp"

#include <gtest/gtest.h>

#include "placed_particles.hpp"

namespace parapet::solver {
namespace {

struct TwoBarriers : LevelChannel {
  TwoBarriers() { gauge.lines.push_back({{1.5, 0.0}, {1.0, 0.0}}); }
};

TEST(Backflow, IsWhatRunsUpstreamBetweenTheBarriers) {
  TwoBarriers c;
  const Fluid f = fluid_of({{0.9, 0.0, 0.01, -2.0, 0.0},    // before the first
                            {1.2, 0.0, 0.02, -0.5, 0.3},    // between them
                            {1.3, 0.0, 0.03, -0.11, 0.0},   //
                            {1.3, 0.0, 0.04, -0.09, 0.0},   // at rest
                            {1.4, 0.0, 0.05, 1.0, 0.0},     // downstream
                            {1.6, 0.0, 0.06, -1.0, 0.0}});  // behind both
  EXPECT_DOUBLE_EQ(backflow(c.gauge, 0, f).share, 0.01);
  EXPECT_DOUBLE_EQ(*backflow(c.gauge, 0, f).speed, 2.0);
  EXPECT_DOUBLE_EQ(backflow(c.gauge, 1, f).share, 0.05);
  EXPECT_DOUBLE_EQ(*backflow(c.gauge, 1, f).speed, 0.5) << "along the channel";
}

TEST(Backflow, ItsSpeedIsThatOfHalfAPercentOfTheMassNotOfADroplet) {
  TwoBarriers c;
  std::vector<Placed> placed{{1.2, 0.0, 0.003, -3.0, 0.0}};
  EXPECT_FALSE(backflow(c.gauge, 1, fluid_of(placed)).speed);
  placed.push_back({1.2, 0.1, 0.003, -0.4, 0.0});
  EXPECT_DOUBLE_EQ(*backflow(c.gauge, 1, fluid_of(placed)).speed, 0.4);
}

}  // namespace
}  // namespace parapet::solver
