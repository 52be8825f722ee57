// Each limit of the time step, alone.
#include "parapet/flow/time_step.hpp"

#include <gtest/gtest.h>

namespace parapet::solver {
namespace {

TEST(TimeStep, AcousticLimit) {
  Numerics n;
  n.sound_speed = 35.0;
  EXPECT_DOUBLE_EQ(stable_time_step(n, {0.007, 0.0, 0.0, 0.0, 1135.0, 0.5}), 0.5 * 0.007 / 35.0);
  EXPECT_DOUBLE_EQ(stable_time_step(n, {0.007, 5.0, 0.0, 0.0, 1135.0, 0.5}), 0.5 * 0.007 / 40.0);
}

TEST(TimeStep, ExplicitViscosityLimitsAsInThePaper) {
  // 0.125 h^2 rho/eta_max = 6.9e-6 s for Table 1 at dx = 5 mm, h = 1.33 dx
  const Numerics n;
  EXPECT_NEAR(stable_time_step(n, {1.33 * 0.005, 0.0, 0.0, 907.26, 1135.0, 0.6}), 6.9e-6, 0.05e-6);
}

TEST(TimeStep, ForceLimit) {
  const Numerics n;
  EXPECT_DOUBLE_EQ(stable_time_step(n, {0.01, 0.0, 1e8, 0.0, 1135.0, 0.6}), 0.25e-5);
}

}  // namespace
}  // namespace parapet::solver
