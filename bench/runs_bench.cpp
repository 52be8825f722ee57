// Whole runs of H10-D45 for 1.6 s of flow on one thread. Names: run/WHAT. CPU seconds are what
// counts; run/profile_5mm says what they went into.
#include <benchmark/benchmark.h>

#include <stdexcept>

#include "states.hpp"

namespace parapet::bench {
namespace {

solver::Result run(double spacing, bool profile) {
  solver::RunOptions options;
  options.stop_time = 1.6;
  options.settled.enabled = false;
  options.profile = profile;
  solver::Result result = solver::simulate(h10_d45(), numerics_of(spacing), options);
  if (result.status != solver::Status::ok) throw std::runtime_error(result.reason);
  return result;
}

void whole_run(benchmark::State& state, double spacing, bool profile) {
  solver::Result result;
  for ([[maybe_unused]] auto _ : state) result = run(spacing, profile);
  const auto steps = static_cast<double>(result.statistics.steps);
  state.counters["steps"] = steps;
  state.counters["particles"] = static_cast<double>(result.mass.particles_released);
  state.counters["cg_per_step"] = static_cast<double>(result.statistics.cg_iterations) / steps;
  state.counters["steps_per_renewal"] =
      steps / static_cast<double>(result.statistics.neighbor_builds);
  if (!result.profile) return;
  for (const solver::StageTime& stage : result.profile->stages) {
    state.counters["share: " + stage.name] = stage.seconds / result.profile->seconds();
  }
}

}  // namespace
}  // namespace parapet::bench

int main(int argc, char** argv) {
  using namespace parapet::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const auto add = [](const char* name, double spacing, bool profile) {
    benchmark::RegisterBenchmark(
        name, [=](benchmark::State& state) { whole_run(state, spacing, profile); })
        ->Unit(benchmark::kSecond)
        ->Iterations(1);
  };
  add("run/h10_d45_10mm", 0.01, false);
  add("run/h10_d45_5mm", 0.005, false);
  add("run/profile_5mm", 0.005, true);
  benchmark::RunSpecifiedBenchmarks();
}
