// Cost of a step against the number of particles and of threads, on H10-D45 after 0.7 s of flow.
// Names: scaling/PARTICLES (about)/threads:N.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <thread>

#include "states.hpp"
#include "stopwatch.hpp"

namespace parapet::bench {
namespace {

struct Size {
  double spacing;  // [m]
  int refinement;
  int particles() const {
    const double dx = spacing / refinement;
    return static_cast<int>(std::lround(0.3 * 0.2 / (dx * dx)));
  }
};

// The state that the benchmarks of one size start from, made when it is first asked for.
class Start {
 public:
  explicit Start(Size size) : size_(size) {}
  const solver::FlowSetup& setup() {
    if (!setup_) setup_ = developed_flow(size_.spacing, 0.7, size_.refinement);
    return *setup_;
  }

 private:
  Size size_;
  std::optional<solver::FlowSetup> setup_;
};

// Every benchmark makes its own flow: a measured one must not start where another has ended.
void steps_of(benchmark::State& state, const std::shared_ptr<Start>& start, int threads) {
  solver::FlowSetup setup = start->setup();
  setup.threads = threads;
  solver::Flow flow(std::move(setup));
  const int steps = std::max(4, 240'000 / flow.fluid().n);
  advance(flow, 5);
  const solver::RunStatistics before = flow.statistics();
  std::vector<Times> turns;
  for ([[maybe_unused]] auto _ : state) {
    for (int turn = 0; turn < 4; ++turn) {
      turns.push_back(measure([&] { advance(flow, steps); }));
    }
  }
  const auto least = [&](double Times::*kind) {
    double best = 1e300;
    for (const Times& t : turns) best = std::min(best, t.*kind);
    return best / steps;
  };
  const auto all = static_cast<double>(flow.statistics().steps - before.steps);
  state.counters["particles"] = flow.fluid().n;
  state.counters["thread_count"] = threads;
  state.counters["wall_s_per_step"] = least(&Times::wall);
  state.counters["cpu_s_per_step"] = least(&Times::cpu);
  state.counters["cg_per_step"] =
      static_cast<double>(flow.statistics().cg_iterations - before.cg_iterations) / all;
  state.counters["time_step"] = flow.last_time_step();
}

}  // namespace
}  // namespace parapet::bench

int main(int argc, char** argv) {
  using namespace parapet::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  // 1,000 to 240,000 particles
  for (const Size size : {Size{0.0075, 1}, Size{0.005, 1}, Size{0.005, 2}, Size{0.005, 3},
                          Size{0.005, 5}, Size{0.005, 10}}) {
    const auto start = std::make_shared<Start>(size);
    for (int threads = 1; threads <= cores; threads *= 2) {
      const std::string name =
          "scaling/" + std::to_string(size.particles()) + "/threads:" + std::to_string(threads);
      benchmark::RegisterBenchmark(
          name.c_str(), [=](benchmark::State& state) { steps_of(state, start, threads); })
          ->Unit(benchmark::kSecond)
          ->Iterations(1)
          ->UseRealTime();
    }
  }
  benchmark::RunSpecifiedBenchmarks();
}
