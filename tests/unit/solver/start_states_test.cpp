// A run that goes on from a state of another design's flow must be the run itself, to the bit.
#include "parapet/solver/start_states.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <thread>
#include <vector>

#include "parapet/solver/simulation.hpp"

namespace parapet::solver {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Numerics coarse(double spacing = 0.02) {
  Numerics numerics;
  numerics.spacing = spacing;
  return numerics;
}

RunOptions until(double time) {
  RunOptions options;
  options.stop_time = time;
  return options;
}

Scene with_barrier(const Barrier& barrier) {
  Scene scene;
  scene.domain_length = 2.0;
  scene.barriers = {barrier};
  return scene;
}

void expect_same(const Result& a, const Result& b) {
  EXPECT_EQ(a.stop_reason, b.stop_reason);
  EXPECT_EQ(a.stop_time, b.stop_time);
  EXPECT_EQ(a.series.columns, b.series.columns);
  ASSERT_EQ(a.series.rows.size(), b.series.rows.size());
  for (std::size_t r = 0; r < a.series.rows.size(); ++r) {
    ASSERT_EQ(a.series.rows[r], b.series.rows[r]) << "sample " << r;
  }
  ASSERT_EQ(a.metrics.size(), b.metrics.size());
  for (std::size_t k = 0; k < a.metrics.size(); ++k) {
    EXPECT_EQ(a.metrics[k].value, b.metrics[k].value) << a.metrics[k].key;
    EXPECT_EQ(a.metrics[k].absent_reason, b.metrics[k].absent_reason);
  }
  EXPECT_EQ(a.statistics.steps, b.statistics.steps);
  EXPECT_EQ(a.statistics.neighbor_builds, b.statistics.neighbor_builds);
  EXPECT_EQ(a.statistics.cg_iterations, b.statistics.cg_iterations);
  EXPECT_EQ(a.statistics.wall_contacts, b.statistics.wall_contacts);
  EXPECT_EQ(a.statistics.max_speed, b.statistics.max_speed);
  EXPECT_EQ(a.statistics.max_density_error, b.statistics.max_density_error);
  EXPECT_EQ(a.statistics.max_particles_inside_walls, b.statistics.max_particles_inside_walls);
  EXPECT_EQ(a.mass.in_domain, b.mass.in_domain);
  EXPECT_EQ(a.mass.left_domain, b.mass.left_domain);
}

// Stems and deflectors of every kind, two barriers, an open channel, another solid's neighbour.
std::vector<Scene> arrangements() {
  std::vector<Scene> scenes;
  Barrier bare;
  scenes.push_back(with_barrier(bare));
  scenes.push_back(with_barrier({.foot_x = 1.1, .deflector = Deflector{}}));
  scenes.push_back(
      with_barrier({.foot_x = 0.9, .height = 0.15, .stem_lean = -26 * degree, .deflector = {}}));
  scenes.push_back(
      with_barrier({.foot_x = 1.3, .height = 0.25, .thickness = 0.05, .deflector = {}}));
  scenes.push_back(with_barrier(
      {.foot_x = 1.0, .stem_lean = 30 * degree, .deflector = Deflector{60 * degree, 0.1}}));
  scenes.push_back(with_barrier({.foot_x = 0.7, .height = 0.05, .deflector = {}}));
  Scene two = with_barrier({.foot_x = 1.1, .deflector = {}});
  two.barriers.push_back({.foot_x = 1.5, .height = 0.05, .deflector = {}});
  scenes.push_back(two);
  Scene open;
  open.domain_length = 2.0;
  scenes.push_back(open);
  return scenes;
}

TEST(StartStates, EveryDesignGivesTheBitsThatItGivesAlone) {
  StartStates starts;
  std::int64_t runs = 0;
  for (const Scene& scene : arrangements()) {
    const Result alone = simulate(scene, coarse(), until(0.9));
    expect_same(simulate(scene, coarse(), until(0.9), {}, &starts), alone);
    ASSERT_GT(alone.statistics.steps, 0);
    runs = starts.use().runs;
  }
  // all but the first, which had nothing to go on from
  EXPECT_EQ(runs, static_cast<std::int64_t>(arrangements().size()) - 1);
}

TEST(StartStates, NoOrderOfTheDesignsMatters) {
  StartStates starts;
  std::vector<Scene> scenes = arrangements();
  for (auto scene = scenes.rbegin(); scene != scenes.rend(); ++scene) {
    expect_same(simulate(*scene, coarse(0.015), until(0.7), {}, &starts),
                simulate(*scene, coarse(0.015), until(0.7)));
  }
}

TEST(StartStates, DesignsSideBySideAndOnThreads) {
  StartStates starts;
  const std::vector<Scene> scenes = arrangements();
  std::vector<Result> together(scenes.size());
  {
    std::vector<std::jthread> jobs;
    for (std::size_t k = 0; k < 4; ++k) {
      jobs.emplace_back([&, k] {
        RunOptions options = until(0.6);
        options.threads = static_cast<int>(1 + k % 2);
        together[k] = simulate(scenes[k], coarse(), options, {}, &starts);
      });
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    expect_same(together[k], simulate(scenes[k], coarse(), until(0.6)));
  }
}

TEST(StartStates, SavesTheStepsUntilTheBarrierComesIntoSight) {
  StartStates starts;
  const Scene scene = arrangements().front();
  const Result first = simulate(scene, coarse(0.01), until(0.45), {}, &starts);
  EXPECT_EQ(starts.use().runs, 0);
  simulate(scene, coarse(0.01), until(0.45), {}, &starts);
  EXPECT_EQ(starts.use().runs, 1);
  // the debris is near the barrier at 0.4 s
  EXPECT_GT(static_cast<double>(starts.use().steps),
            0.6 * static_cast<double>(first.statistics.steps));
}

TEST(StartStates, OtherFlowsShareNothing) {
  StartStates starts;
  const Scene scene = arrangements().front();
  const RunOptions options = until(0.3);
  simulate(scene, coarse(), options, {}, &starts);
  std::vector<std::pair<Scene, Numerics>> others;
  const auto other = [&](const auto& change) {
    others.emplace_back(scene, coarse());
    change(others.back().first, others.back().second);
  };
  other([](Scene& s, Numerics&) { s.material.yield_stress = 91.0; });
  other([](Scene& s, Numerics&) { s.slope += 1e-9; });
  other([](Scene& s, Numerics&) { s.reservoir_height = 0.22; });
  other([](Scene& s, Numerics&) { s.solids = {{{{1.8, 0.0}, {1.9, 0.0}, {1.9, 0.1}}}}; });
  other([](Scene& s, Numerics&) { s.wall_slip = WallSlip::free_slip; });
  other([](Scene&, Numerics& n) { n.spacing = 0.021; });
  other([](Scene&, Numerics& n) { n.lattice_jitter = 0.01; });
  other([](Scene&, Numerics& n) { n.cg_tolerance = 0.4; });
  for (const auto& [changed, numerics] : others) simulate(changed, numerics, options, {}, &starts);
  RunOptions finer = options;
  finer.series_interval = 0.004;
  simulate(scene, coarse(), finer, {}, &starts);
  EXPECT_EQ(starts.use().runs, 0);
}

// The explicit scheme, jitter, a run until rest and one that stops early: whatever else a user may
// choose.
TEST(StartStates, OtherChoicesGiveTheSameBitsToo) {
  Numerics explicit_scheme = coarse(0.03);
  explicit_scheme.integrator = Integrator::rk4_explicit;
  Numerics jittered = coarse();
  jittered.lattice_jitter = 0.01;
  jittered.sound_speed_floor = 1.0;
  RunOptions rest = until(0.5);
  rest.until_rest = true;
  for (const Numerics& numerics : {explicit_scheme, jittered}) {
    for (const RunOptions& options : {until(0.42), rest}) {
      StartStates starts;
      for (const Scene& scene : {arrangements()[0], arrangements()[1]}) {
        expect_same(simulate(scene, numerics, options, {}, &starts),
                    simulate(scene, numerics, options));
      }
      EXPECT_EQ(starts.use().runs, 1);
    }
  }
}

// Debris that stops before it reaches anything: the run ends by itself, in both ways at one time.
TEST(StartStates, AFlowThatStopsOnItsWay) {
  StartStates starts;
  std::vector<Scene> scenes = {with_barrier({.foot_x = 1.6, .deflector = {}}),
                               with_barrier({.foot_x = 1.2, .deflector = {}})};
  for (Scene& scene : scenes) {
    scene.slope = 3 * degree;
    scene.material.yield_stress = 400.0;
    const Result alone = simulate(scene, coarse(), until(4.0));
    EXPECT_EQ(alone.stop_reason, StopReason::metrics_final);
    expect_same(simulate(scene, coarse(), until(4.0), {}, &starts), alone);
  }
  EXPECT_EQ(starts.use().runs, 1);
}

TEST(StartStates, MemoryIsBounded) {
  const Scene scene = arrangements().front();
  StartStates tiny(1);  // room for one state, which is always kept
  for (int k = 0; k < 3; ++k) {
    expect_same(simulate(scene, coarse(), until(0.4), {}, &tiny),
                simulate(scene, coarse(), until(0.4)));
  }
  EXPECT_EQ(tiny.use().runs, 2);
}

// Whoever asks for pictures of the whole run gets them.
TEST(StartStates, FramesAreOfTheWholeRun) {
  StartStates starts;
  const Scene scene = arrangements().front();
  RunOptions options = until(0.2);
  simulate(scene, coarse(), options, {}, &starts);
  options.frame_interval = 0.1;
  std::vector<double> times;
  Callbacks callbacks;
  callbacks.on_frame = [&](const Frame& frame) { times.push_back(frame.time); };
  simulate(scene, coarse(), options, callbacks, &starts);
  EXPECT_EQ(times, (std::vector<double>{0.0, 0.1, 0.2, 0.2}));  // and the last state
}

}  // namespace
}  // namespace parapet::solver
