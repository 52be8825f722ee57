// How the design load is spread over a barrier.
#include <gtest/gtest.h>

#include <cmath>

#include "parapet/solver/simulation.hpp"

namespace parapet::solver {
namespace {

Vec2 mean_force(const Result& result, const std::string& column, double from, double to) {
  std::size_t x = 0;
  while (result.series.columns[x] != column) ++x;
  Vec2 sum;
  double samples = 0.0;
  for (const auto& row : result.series.rows) {
    if (row[0] <= from + 1e-9 || row[0] > to + 1e-9) continue;
    sum = sum + Vec2{row[x], row[x + 1]};
    samples += 1.0;
  }
  return (1.0 / samples) * sum;
}

// The integral of the profile is the normal force of the load cell over the same window. The series
// has means over 1 ms, the window ends with a step: at most a sample of a hundred more or less,
// whose force is within twice the mean.
TEST(LoadProfile, AddsUpToTheNormalForceInTheWindow) {
  Scene scene;
  scene.barriers = {Barrier{}};
  scene.barriers.front().deflector = Deflector{0.6, 0.065};
  Numerics numerics;
  numerics.spacing = 0.01;
  RunOptions options = usual_run_options(scene);
  options.series_interval = 0.001;
  const Result result = simulate(scene, numerics, options);
  ASSERT_EQ(result.status, Status::ok);
  ASSERT_EQ(result.loads.size(), 2u);
  const LoadProfile &stem = result.loads[0], &plate = result.loads[1];
  EXPECT_FALSE(stem.deflector);
  EXPECT_TRUE(plate.deflector);
  EXPECT_EQ(stem.window_end, result.find_metric("barrier_1_design_force_time_s")->value.value());
  EXPECT_NEAR(stem.window, 0.7 * std::sqrt(0.2 / 9.81), 1e-3);
  EXPECT_DOUBLE_EQ(stem.edge.back(), 0.1);
  EXPECT_DOUBLE_EQ(plate.edge.back(), 0.065);
  ASSERT_EQ(plate.pressure.size(), 7u);
  const double from = stem.window_end - stem.window, to = stem.window_end;
  const Vec2 whole = mean_force(result, "barrier_1_force_x_n_per_m", from, to);
  const Vec2 on_plate = mean_force(result, "barrier_1_deflector_force_x_n_per_m", from, to);
  const double size = norm(whole);
  EXPECT_NEAR(size, result.find_metric("barrier_1_design_force_n_per_m")->value.value(),
              0.03 * size);
  EXPECT_NEAR(stem.normal_force(), dot(whole - on_plate, stem.normal), 0.03 * size);
  EXPECT_NEAR(plate.normal_force(), dot(on_plate, plate.normal), 0.03 * size);
  EXPECT_GT(stem.normal_force(), 0.2 * size) << "the flow pushes the stem downstream";
  EXPECT_GT(plate.normal_force(), 0.0) << "and lifts the plate";
}

}  // namespace
}  // namespace parapet::solver
