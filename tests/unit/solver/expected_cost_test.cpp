// What is said of a run before it begins, against the run.
#include "parapet/solver/expected_cost.hpp"

#include <gtest/gtest.h>

namespace parapet::solver {
namespace {

struct Setting {
  const char* name;
  double spacing, stop_time;
  Integrator integrator;
};

void PrintTo(const Setting& setting, std::ostream* out) {
  *out << setting.name;
}

class ExpectedCosts : public testing::TestWithParam<Setting> {};

// Particles are counted, so they are met but for the rounding of the lattice. Time steps depend
// on the speeds of the run, of which one is guessed: these runs give 0.93 to 1.07 of the truth.
TEST_P(ExpectedCosts, AreMetByTheRun) {
  Scene scene;
  Barrier barrier;
  barrier.deflector = Deflector{0.785, 0.065};
  scene.barriers = {barrier};
  Numerics numerics;
  numerics.spacing = GetParam().spacing;
  numerics.integrator = GetParam().integrator;
  RunOptions options;
  options.stop_time = GetParam().stop_time;
  options.settled.enabled = false;
  const ExpectedCost expected = expected_cost(scene, numerics, options);
  const Result result = simulate(scene, numerics, options);
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  const auto particles = static_cast<double>(result.mass.particles_released);
  EXPECT_NEAR(expected.particles, particles, 0.02 * particles);
  EXPECT_EQ(expected.samples, static_cast<double>(result.series.rows.size() - 1));
  const auto steps = static_cast<double>(result.statistics.steps);
  EXPECT_GT(expected.steps, 0.8 * steps);
  EXPECT_LT(expected.steps, 1.25 * steps);
  EXPECT_EQ(expected.particle_steps(), expected.particles * expected.steps);
}

INSTANTIATE_TEST_SUITE_P(
    Runs, ExpectedCosts,
    testing::Values(Setting{"Coarse", 0.025, 0.8, Integrator::implicit_viscosity},
                    Setting{"Finer", 0.0125, 0.5, Integrator::implicit_viscosity},
                    Setting{"Explicit", 0.025, 0.3, Integrator::rk4_explicit}),
    [](const auto& test) { return std::string(test.param.name); });

// Water goes faster, with the steps of the settings for thin fluids.
TEST(ExpectedCost, KnowsThinFluids) {
  Scene scene;
  scene.barriers = {Barrier{}};
  scene.material = {.density = 1000.0, .yield_stress = 0.0, .consistency = 1e-3, .flow_index = 1.0};
  Numerics numerics;
  numerics.spacing = 0.025;
  numerics.thin_fluid = ThinFluid::automatic;
  RunOptions options;
  options.stop_time = 0.8;
  options.settled.enabled = false;
  const ExpectedCost expected = expected_cost(scene, numerics, options);
  const Result result = simulate(scene, numerics, options);
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  const auto steps = static_cast<double>(result.statistics.steps);
  EXPECT_GT(expected.steps, 0.8 * steps);
  EXPECT_LT(expected.steps, 1.25 * steps);
  numerics.thin_fluid = ThinFluid::off;
  EXPECT_LT(expected_cost(scene, numerics, options).neighbors, expected.neighbors);
}

// More of anything costs more, by the right power.
TEST(ExpectedCost, GrowsWithParticlesWallsAndSamples) {
  const Scene scene;
  Numerics fine, coarse;
  fine.spacing = 0.005;
  coarse.spacing = 0.01;
  const RunOptions options;
  const ExpectedCost a = expected_cost(scene, coarse, options);
  const ExpectedCost b = expected_cost(scene, fine, options);
  EXPECT_NEAR(b.particles / a.particles, 4.0, 1e-9);
  EXPECT_NEAR(b.wall_points / a.wall_points, 2.0, 1e-9);
  EXPECT_NEAR(b.steps / a.steps, 2.0, 0.2);  // whole steps between samples
  EXPECT_GT(b.memory, a.memory);
  Scene longer = scene;
  longer.domain_length *= 100.0;
  EXPECT_EQ(expected_cost(longer, fine, options).steps, b.steps);
  EXPECT_GT(expected_cost(longer, fine, options).wall_points, b.wall_points);
  RunOptions often = options;
  often.series_interval /= 1000.0;
  EXPECT_GT(expected_cost(scene, fine, often).series_memory, 900.0 * b.series_memory);
}

}  // namespace
}  // namespace parapet::solver
