// The stopwatch on a clock that is set by hand: nothing here depends on how fast the machine is.
#include "parapet/flow/stage_timer.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "parapet/solver/simulation.hpp"

namespace parapet::solver {
namespace {

const StageTime* find(const Profile& profile, const std::string& name) {
  for (const StageTime& stage : profile.stages) {
    if (stage.name == name) return &stage;
  }
  return nullptr;
}

struct HandClock {
  double now = 100.0;  // the timer must not care where the clock starts
  StageTimer timer{[this] { return now; }};
};

TEST(StageTimer, AStageInsideAnotherTakesItsTimeFromIt) {
  HandClock c;
  c.now += 1.0;  // other
  {
    const StageScope outer(&c.timer, Stage::conjugate_gradients);
    c.now += 2.0;
    {
      const StageScope inner(&c.timer, Stage::viscous_matrix);
      c.now += 4.0;
    }
    c.now += 8.0;
  }
  c.now += 16.0;  // other
  const Profile p = c.timer.profile();
  ASSERT_EQ(p.stages.size(), 3U);  // stages never entered are not listed
  EXPECT_EQ(find(p, "conjugate gradients")->seconds, 10.0);
  EXPECT_EQ(find(p, "viscous matrix")->seconds, 4.0);
  EXPECT_EQ(find(p, "other")->seconds, 17.0);
  EXPECT_EQ(find(p, "conjugate gradients")->calls, 1);
  EXPECT_EQ(p.seconds(), 31.0);
}

TEST(StageTimer, SumsCallsAndMayBeReadWhileItRuns) {
  HandClock c;
  for (int k = 0; k < 3; ++k) {
    const StageScope scope(&c.timer, Stage::density_rate);
    c.now += 0.5;
  }
  EXPECT_EQ(find(c.timer.profile(), "density rate")->seconds, 1.5);
  EXPECT_EQ(find(c.timer.profile(), "density rate")->calls, 3);
  const StageScope scope(&c.timer, Stage::density_rate);
  c.now += 1.0;
  EXPECT_EQ(find(c.timer.profile(), "density rate")->seconds, 2.5);
}

TEST(StageTimer, PairsAreThoseOfTheRowsInUse) {
  HandClock c;
  c.timer.set_pairs({10, 200, 30, 300});
  { const StageScope scope(&c.timer, Stage::gradients); }      // fluid and walls
  { const StageScope scope(&c.timer, Stage::wall_boundary); }  // walls
  { const StageScope scope(&c.timer, Stage::integrate); }      // no pairs
  c.timer.set_pairs({10, 100, 10, 200});
  { const StageScope scope(&c.timer, Stage::gradients); }
  {
    const StageScope scope(&c.timer, Stage::conjugate_gradients);  // fluid
    c.timer.add_visits(Stage::conjugate_gradients, 4);
  }
  const Profile p = c.timer.profile();
  EXPECT_EQ(find(p, "gradients, rheology")->pairs, 230 + 110);
  EXPECT_EQ(find(p, "wall boundary")->pairs, 30);
  EXPECT_EQ(find(p, "integrate")->pairs, 0);
  EXPECT_EQ(find(p, "conjugate gradients")->pairs, 5 * 100);
  EXPECT_EQ(find(p, "conjugate gradients")->calls, 1);
  EXPECT_EQ(p.fluid_neighbors, 15.0);
  EXPECT_EQ(p.wall_neighbors, 2.0);
  EXPECT_DOUBLE_EQ(p.slots_per_pair, 500.0 / 340.0);
}

TEST(StageTimer, CountsWhatDecidedTheStep) {
  HandClock c;
  c.timer.count_step(TimeStepLimit::acoustic, 1.0, 1.0);
  c.timer.count_step(TimeStepLimit::acoustic, 0.5, 1.0);
  c.timer.count_step(TimeStepLimit::acceleration, 1.0, 2.0);
  const Profile p = c.timer.profile();
  EXPECT_EQ(p.steps_acoustic, 2);
  EXPECT_EQ(p.steps_acceleration, 1);
  EXPECT_EQ(p.steps_viscous, 0);
  EXPECT_EQ(p.step_shortening, 1.0 - 2.5 / 4.0);
}

TEST(StageTimer, WithoutATimerAScopeDoesNothing) {
  const StageScope scope(nullptr, Stage::gradients);
}

TEST(TimeStep, TheSmallestLimitDecides) {
  const Numerics numerics;
  TimeStepInput in{0.00665, 1.0, 10.0, 0.0, 1135.0, 0.8};
  EXPECT_EQ(deciding_limit(numerics, in), TimeStepLimit::acoustic);
  in.max_acceleration = 1e5;
  EXPECT_EQ(deciding_limit(numerics, in), TimeStepLimit::acceleration);
  in.max_viscosity = 900.0;
  EXPECT_EQ(deciding_limit(numerics, in), TimeStepLimit::viscous);
}

// A whole run: the stages account for all of its time, its steps and its pairs, and the answer is
// that of a run nobody measures.
TEST(Profile, AccountsForTheWholeRun) {
  Scene scene;
  scene.reservoir_length = 0.2;
  scene.reservoir_height = 0.1;
  scene.barriers = {{.foot_x = 0.4, .height = 0.06, .deflector = Deflector{0.5, 0.04}}};
  Numerics numerics;
  numerics.spacing = 0.02;
  RunOptions options;
  options.stop_time = 0.3;
  const Result plain = simulate(scene, numerics, options);
  options.profile = true;
  const Result measured = simulate(scene, numerics, options);
  EXPECT_FALSE(plain.profile);
  ASSERT_TRUE(measured.profile);
  EXPECT_EQ(plain.series.rows.size(), measured.series.rows.size());
  EXPECT_EQ(plain.series.rows.back().at(1), measured.series.rows.back().at(1));  // kinetic energy
  const Profile& p = *measured.profile;
  const RunStatistics& statistics = measured.statistics;
  EXPECT_EQ(p.steps_acoustic + p.steps_acceleration + p.steps_viscous, statistics.steps);
  EXPECT_EQ(find(p, "neighbour rows")->calls, statistics.neighbor_builds);
  EXPECT_EQ(find(p, "pressure force")->calls, statistics.steps);
  EXPECT_EQ(find(p, "gradients, rheology")->calls,
            (statistics.steps + numerics.steps_per_solve - 1) / numerics.steps_per_solve);
  EXPECT_EQ(find(p, "density rate")->pairs, find(p, "pressure force")->pairs);
  EXPECT_GT(find(p, "conjugate gradients")->pairs, find(p, "viscous matrix")->pairs);
  // a lattice at h/dx = 1.33 has 20 within reach; this little block has many at its edge
  EXPECT_GT(p.fluid_neighbors, 10.0);
  EXPECT_LT(p.fluid_neighbors, 22.0);
  EXPECT_GE(p.slots_per_pair, 1.0);
  EXPECT_GE(p.step_shortening, -implicit_step_excess);
  EXPECT_LT(p.step_shortening, 0.2) << "an interval has four steps or more here";
  EXPECT_GT(p.rest_share, 0.0) << "the block starts at rest";
  EXPECT_LT(p.rest_share, 0.5) << "and is still flowing at the end";
  EXPECT_LT(p.steps_after_last_change, 0.1) << "so that its metrics still change";
  double sum = 0.0;
  for (const StageTime& stage : p.stages) {
    EXPECT_GE(stage.seconds, 0.0) << stage.name;
    EXPECT_GT(stage.calls, 0) << stage.name;
    sum += stage.seconds / p.seconds();
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);  // rounding alone
}

TEST(Profile, SaysWhatCameAfterTheLastChangeOfAMetric) {
  Scene scene;
  scene.reservoir_length = 0.2;
  scene.reservoir_height = 0.1;
  scene.barriers = {{.foot_x = 0.4, .height = 0.12, .deflector = {}}};
  Numerics numerics;
  numerics.spacing = 0.02;
  RunOptions options;
  options.stop_time = 3.0;
  options.settled.enabled = false;
  options.profile = true;
  const Result whole = simulate(scene, numerics, options);
  options.settled.enabled = true;
  const Result ended = simulate(scene, numerics, options);
  ASSERT_EQ(ended.stop_reason, StopReason::metrics_final);
  EXPECT_GT(whole.profile->steps_after_last_change, ended.profile->steps_after_last_change);
  EXPECT_GT(whole.profile->rest_share, ended.profile->rest_share);
  // at its end a run has waited for a sixteenth of its time, or 0.125 s
  EXPECT_GT(ended.profile->steps_after_last_change, 0.1);
}

}  // namespace
}  // namespace parapet::solver
