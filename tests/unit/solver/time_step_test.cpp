// Each limit of the time step, alone.
#include "parapet/flow/time_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(DividingStep, WholeStepsCoverTheTimeLeft) {
  EXPECT_DOUBLE_EQ(dividing_step(0.2, 0.3, 0.1), 0.2) << "one is enough";
  EXPECT_DOUBLE_EQ(dividing_step(0.9, 0.3, 0.0), 0.3);
  EXPECT_DOUBLE_EQ(dividing_step(1.0, 0.3, 0.0), 0.25);
  EXPECT_DOUBLE_EQ(dividing_step(1.0, 0.3, 0.1), 0.25) << "thirds are longer by 11 %";
  EXPECT_DOUBLE_EQ(dividing_step(1.0, 0.3, 0.12), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(dividing_step(0.32, 0.3, 0.1), 0.32) << "nothing is left over";
  EXPECT_DOUBLE_EQ(dividing_step(0.34, 0.3, 0.1), 0.17);
}

// The stable step wavers by 2 % from step to step, as it does with the fastest particle.
struct March {
  int steps;
  double end, longest;  // [s], step over the stable one
};
March march(double interval, double excess) {
  March m{0, 0.0, 0.0};
  for (int sample = 1; sample <= 100; ++sample) {
    while (sample * interval - m.end > 1e-9 * interval) {
      const double stable = 1.0 + 0.02 * std::sin(2.0 * m.steps);
      const double dt = dividing_step(sample * interval - m.end, stable, excess);
      m.longest = std::max(m.longest, dt / stable);
      m.end += dt;
      ++m.steps;
    }
    EXPECT_NEAR(m.end, sample * interval, 1e-9 * interval) << sample;
  }
  return m;
}

TEST(DividingStep, WastesNoStepWhereTheStableOneWavers) {
  for (const double interval : {7.2, 8.5, 12.4}) {
    const March rigid = march(interval, 0.0), spread = march(interval, 0.1);
    EXPECT_LE(rigid.longest, 1.0 + 1e-9);
    EXPECT_LE(spread.longest, 1.1 + 1e-9);
    EXPECT_EQ(spread.steps, 100 * static_cast<int>(interval)) << interval;
    EXPECT_GE(rigid.steps, 100 * static_cast<int>(interval + 1.0)) << interval;
  }
}

}  // namespace
}  // namespace parapet::solver
