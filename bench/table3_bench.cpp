// The fifteen rows of Table 3 to their settled ends, two side by side. Minutes.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "parapet/designs/study_spec.hpp"
#include "parapet/solver/simulation.hpp"
#include "parapet/study/side_by_side.hpp"

namespace parapet::bench {
namespace {

constexpr int jobs = 2;

void table3(benchmark::State& state, double spacing) {
  const designs::SweepSpec sweep =
      designs::load_sweep(std::filesystem::path(PARAPET_DESIGNS) / "table3.json");
  // Rows with more to do first, as `parapet table3` has them: by their barriers.
  std::vector<const designs::SweepRow*> rows;
  for (const designs::SweepRow& row : sweep.rows) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) {
    return a->spec.scene.barriers.size() > b->spec.scene.barriers.size();
  });
  std::vector<double> stop_times(rows.size(), 0.0);
  for ([[maybe_unused]] auto _ : state) {
    study::run_side_by_side(
        rows.size(), jobs,
        [&](std::size_t k, int threads) {
          solver::Numerics numerics = rows[k]->spec.numerics;
          numerics.spacing = spacing;
          solver::RunOptions options = rows[k]->spec.run;
          options.threads = threads;
          const solver::Result result = solver::simulate(rows[k]->spec.scene, numerics, options);
          if (result.status != solver::Status::ok) throw std::runtime_error(result.reason);
          stop_times[k] = result.stop_time;
        },
        [] { return false; });
  }
  double flow = 0.0;
  for (const double time : stop_times) flow += time;
  state.counters["seconds_of_flow"] = flow;
  state.counters["rows"] = static_cast<double>(rows.size());
}

}  // namespace
}  // namespace parapet::bench

int main(int argc, char** argv) {
  using namespace parapet::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const auto add = [](const char* name, double spacing) {
    benchmark::RegisterBenchmark(name, [=](benchmark::State& state) { table3(state, spacing); })
        ->Unit(benchmark::kSecond)
        ->Iterations(1)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  };
  add("table3/10mm", 0.01);
  add("table3/5mm", 0.005);
  benchmark::RunSpecifiedBenchmarks();
}
