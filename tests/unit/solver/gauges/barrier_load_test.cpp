// Loads on barriers: of impulses given by hand, and of one particle that flies into a stem.
#include "gauges/barrier_load.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "parapet/flow/flow.hpp"

namespace parapet::solver {
namespace {

// One barrier, hit by the given impulse along x [N s/m] in a step of the given length.
void step(LoadGauge& gauge, double& time, double length, double impulse, double moment = 0.0) {
  time += length;
  gauge.observe({{{impulse, 0.0}, moment}}, length, time);
}

TEST(LoadGauge, ReadsTheMeanSinceTheLastReading) {
  LoadGauge gauge(1);
  double time = 0.0;
  step(gauge, time, 0.002, 1.0, 0.30);
  step(gauge, time, 0.003, 2.0, 0.05);
  // 3 N s/m and 0.35 N s in 5 ms
  std::vector<BarrierLoad> loads = gauge.read();
  ASSERT_EQ(loads.size(), 1u);
  EXPECT_DOUBLE_EQ(loads[0].force.x, 600.0);
  EXPECT_DOUBLE_EQ(loads[0].moment, 70.0);
  step(gauge, time, 0.004, 1.0);
  loads = gauge.read();
  EXPECT_DOUBLE_EQ(loads[0].force.x, 250.0);
  EXPECT_EQ(loads[0].moment, 0.0);
  loads = gauge.read();  // nothing since
  EXPECT_EQ(loads[0].force.x, 0.0);
}

TEST(LoadGauge, PeaksAreMeansOverFiveMilliseconds) {
  LoadGauge gauge(1);
  double time = 0.0;
  for (int k = 0; k < 4; ++k) step(gauge, time, 0.001, 9.0, 9.0);
  EXPECT_EQ(gauge.peaks()[0].force, 0.0) << "4 ms are not enough";
  EXPECT_LT(gauge.peaks()[0].force_time, 0.0);
  step(gauge, time, 0.001, 0.0);
  // 36 N s/m in 5 ms
  EXPECT_NEAR(gauge.peaks()[0].force, 7200.0, 1e-9);
  EXPECT_NEAR(gauge.peaks()[0].moment, 7200.0, 1e-9);
  EXPECT_DOUBLE_EQ(gauge.peaks()[0].force_time, 0.005);
  for (int k = 0; k < 20; ++k) step(gauge, time, 0.001, 1.0);
  EXPECT_NEAR(gauge.peaks()[0].force, 7200.0, 1e-9) << "a smaller load leaves the peak alone";
  EXPECT_DOUBLE_EQ(gauge.peaks()[0].force_time, 0.005);
}

TEST(LoadGauge, TheWindowIsTheFewestStepsThatFillFiveMilliseconds) {
  LoadGauge gauge(1);
  double time = 0.0;
  for (int k = 0; k < 10; ++k) step(gauge, time, 0.002, k == 5 ? 3.0 : 0.0);
  // three steps of 2 ms: 3 N s/m in 6 ms
  EXPECT_NEAR(gauge.peaks()[0].force, 500.0, 1e-10);
}

TEST(LoadGauge, ThePeakIsTheSizeOfTheForceAndTheMomentOnlyThatDownstream) {
  LoadGauge gauge(2);
  gauge.observe({{{-3.0, 4.0}, -2.0}, {{0.0, 1.0}, 0.5}}, 0.010, 0.010);
  EXPECT_DOUBLE_EQ(gauge.peaks()[0].force, 500.0);
  EXPECT_EQ(gauge.peaks()[0].moment, 0.0);
  EXPECT_DOUBLE_EQ(gauge.peaks()[1].force, 100.0);
  EXPECT_DOUBLE_EQ(gauge.peaks()[1].moment, 50.0);
}

// A stem from (1, 0) to (1, 1) and particles that fly against it, without weight or viscosity. What
// the stem feels is what the particles lose: the pair forces are central and equal and opposite,
// and what the contact rule takes from a particle it gives to the stem.
struct Stem {
  Flow flow;

  explicit Stem(const std::vector<InitialParticle>& particles) : flow(setup(particles)) {}

  static FlowSetup setup(const std::vector<InitialParticle>& particles) {
    FlowSetup s;
    s.numerics.spacing = 0.01;
    s.material.density = 1000.0;
    s.material.yield_stress = s.material.consistency = 0.0;
    s.wall_slip = WallSlip::free_slip;
    s.n_barriers = 1;
    add_outline(s.solids, {{1.0, 0.0}, {1.0, 1.0}, {1.1, 1.0}, {1.1, 0.0}}, 0, true);
    s.particles = particles;
    return s;
  }
};

TEST(BarrierLoad, OfOneParticleIsTheMomentumItLoses) {
  constexpr double mass = 0.1, speed = 2.0, height = 0.5;
  Stem stem({{0.95, height, speed, 0.0, 1000.0, mass}});
  LoadGauge gauge(1);
  while (stem.flow.time() < 0.05) {
    ASSERT_FALSE(stem.flow.step(0.001));
    gauge.observe(stem.flow.take_impulses(), stem.flow.last_time_step(), stem.flow.time());
  }
  const Fluid& f = std::as_const(stem.flow).fluid();
  ASSERT_LT(f.u[0], 0.5 * speed) << "the stem has stopped it";
  const BarrierLoad load = gauge.read().front();
  const double lost_x = mass * (speed - f.u[0]), lost_z = -mass * f.w[0];
  EXPECT_NEAR(load.force.x * stem.flow.time(), lost_x, 1e-12 * mass * speed);
  EXPECT_NEAR(load.force.z * stem.flow.time(), lost_z, 1e-12 * mass * speed);
  // About the foot, positive downstream: z p_x - (x - 1) p_z. It flies at half the stem's height.
  const double before = height * mass * speed;
  const double after = mass * (f.z[0] * f.u[0] - (f.x[0] - 1.0) * f.w[0]);
  EXPECT_NEAR(load.moment * stem.flow.time(), before - after, 1e-12 * before);
  EXPECT_NEAR(load.moment / load.force.x, height, 1e-3);
}

TEST(BarrierLoad, HoldsWhatTheContactRuleTakes) {
  // fast enough to get through the pressure of the wall points to the face itself
  constexpr double mass = 0.1, speed = 15.0, height = 0.25;
  Stem stem({{0.97, height, speed, 3.0, 1000.0, mass}});
  double force = 0.0, moment = 0.0;
  while (stem.flow.statistics().wall_contacts == 0) {
    ASSERT_FALSE(stem.flow.step(0.001));
    for (const BarrierImpulse& impulse : stem.flow.take_impulses()) {
      force += impulse.force.x;
      moment += impulse.moment;
    }
    ASSERT_LT(stem.flow.time(), 0.1);
  }
  const Fluid& f = std::as_const(stem.flow).fluid();
  EXPECT_NEAR(force, mass * (speed - f.u[0]), 1e-12 * mass * speed);
  EXPECT_NEAR(moment / force, height, 0.01);
}

}  // namespace
}  // namespace parapet::solver
