// The undisturbed flow along the channel.
#include "parapet/solver/approach.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "parapet/solver/simulation.hpp"

namespace parapet::solver {
namespace {

Numerics coarse() {
  Numerics numerics;
  numerics.spacing = 0.01;
  return numerics;
}

double value(const Result& result, const char* key) {
  return result.find_metric(key)->value.value();
}

// A run that is gauged at one place reads the same there: places of the profile lie at multiples of
// a fourth of the window of 40 mm, so 0.9 m is one of them.
TEST(ApproachProfile, HasAtAPlaceWhatARunGaugedThereReads) {
  Scene scene;
  scene.barriers = {Barrier{}};
  scene.barriers.front().foot_x = 1.4;
  const UndisturbedRun run =
      simulate_undisturbed(undisturbed(scene), coarse(), usual_run_options(scene));
  ASSERT_EQ(run.result.status, Status::ok);
  Scene open;
  open.monitor_x = 0.9;
  const Result there = simulate(open, coarse(), usual_run_options(open));
  const Approach flow = run.profile.at(0.9);
  EXPECT_NEAR(flow.front_velocity.value(), value(there, "front_velocity_m_s"), 1e-9);
  EXPECT_NEAR(flow.depth.value(), value(there, "flow_depth_max_m"), 1e-9);
  EXPECT_NEAR(flow.froude_number(open).value(), value(there, "froude_number"), 1e-9);
  // and at the last barrier's foot what the run itself says
  EXPECT_NEAR(run.profile.at(1.4).depth.value(), value(run.result, "flow_depth_max_m"), 1e-9);
}

TEST(ApproachProfile, IsLinearBetweenPlacesAndAbsentWhereTheFlowDoesNotCome) {
  ApproachProfile profile;
  profile.x = {0.0, 1.0, 2.0};
  profile.places = {{1.0, 0.2}, {3.0, 0.1}, {std::nullopt, 0.1}};
  EXPECT_DOUBLE_EQ(*profile.at(0.25).front_velocity, 1.5);
  EXPECT_DOUBLE_EQ(*profile.at(0.25).depth, 0.175);
  EXPECT_DOUBLE_EQ(*profile.at(1.0).front_velocity, 3.0);
  EXPECT_FALSE(profile.at(1.5).front_velocity);
  EXPECT_DOUBLE_EQ(*profile.at(2.0).depth, 0.1);
  EXPECT_EQ(profile.at(2.1), Approach{});
  EXPECT_EQ(profile.at(-0.1), Approach{});
  EXPECT_EQ(ApproachProfile{}.at(1.0), Approach{});
}

// The coefficients, times the hand formulas, are the load.
TEST(ApproachCoefficients, GiveTheDesignLoadBack) {
  Scene scene;
  scene.barriers = {Barrier{}};
  RunOptions options = usual_run_options(scene);
  options.approach = {{1.8, 0.05}};
  const Result result = simulate(scene, coarse(), options);
  const double force = value(result, "barrier_1_design_force_n_per_m");
  EXPECT_NEAR(value(result, "barrier_1_hydrodynamic_coefficient") * 1135.0 * 1.8 * 1.8 * 0.05,
              force, 1e-9 * force);
  EXPECT_NEAR(
      value(result, "barrier_1_hydrostatic_coefficient") * 0.5 * 1135.0 * 9.81 * 0.05 * 0.05, force,
      1e-9 * force);
}

}  // namespace
}  // namespace parapet::solver
