// Two ways to do the same work, one after the other in short turns, so that both meet the same
// machine. Names: compare/WHAT; the counters are the answer, the times are not.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "states.hpp"
#include "stopwatch.hpp"

namespace parapet::bench {
namespace {

// Particles of 1 mm, as many as the developed flow has room for (53,000).
const solver::FlowSetup& fine_flow() {
  static const solver::FlowSetup setup = developed_flow(0.005, 0.7, 5);
  return setup;
}

// Both flows pass through the same states, bit for bit, so that every turn is the same work for
// both. The quickest turn is the one that other programs have disturbed least.
void threads_60k(benchmark::State& state) {
  constexpr int turns = 6, steps = 5;
  std::unique_ptr<solver::Flow> flows[2];
  for (int k = 0; k < 2; ++k) {
    solver::FlowSetup own = fine_flow();
    own.threads = k + 1;
    flows[k] = std::make_unique<solver::Flow>(std::move(own));
    advance(*flows[k], steps);
  }
  for ([[maybe_unused]] auto _ : state) {
    std::vector<double> wall[2], cpu[2];
    for (int turn = 0; turn < turns; ++turn) {
      for (int k = 0; k < 2; ++k) {
        const Times t = measure([&] { advance(*flows[k], steps); });
        wall[k].push_back(t.wall);
        cpu[k].push_back(t.cpu);
      }
    }
    double best[2];
    for (int k = 0; k < 2; ++k) best[k] = *std::min_element(wall[k].begin(), wall[k].end());
    state.counters["speedup"] = best[0] / best[1];
    state.counters["ms_per_step"] = 1e3 * best[0] / steps;
  }
  state.counters["particles"] = flows[0]->fluid().n;
}

double particle_step(solver::Flow& flow, int steps) {
  const Times t = measure([&] { advance(flow, steps); });
  return t.cpu / (static_cast<double>(steps) * flow.fluid().n);
}

// CPU time of a particle and step at 1 mm over that at 5 mm, from the same moment of the flow.
void size_60k(benchmark::State& state) {
  solver::Flow small(developed_flow(0.005, 0.7, 1));
  solver::Flow large(fine_flow());
  advance(small, 10);
  advance(large, 10);
  for ([[maybe_unused]] auto _ : state) {
    const auto iterations = [&](const solver::Flow& flow) {
      return static_cast<double>(flow.statistics().cg_iterations);
    };
    const double before[2] = {iterations(small), iterations(large)};
    std::vector<double> costs[2];
    for (int turn = 0; turn < 4; ++turn) {
      costs[0].push_back(particle_step(small, 125));
      costs[1].push_back(particle_step(large, 5));
    }
    const double cost[2] = {*std::min_element(costs[0].begin(), costs[0].end()),
                            *std::min_element(costs[1].begin(), costs[1].end())};
    state.counters["cost_ratio"] = cost[1] / cost[0];
    state.counters["ns_5mm"] = 1e9 * cost[0];
    state.counters["ns_1mm"] = 1e9 * cost[1];
    state.counters["cg_per_step_5mm"] = (iterations(small) - before[0]) / 500.0;
    state.counters["cg_per_step_1mm"] = (iterations(large) - before[1]) / 20.0;
  }
}

// CPU time of a second of flow, from the same moment: 0.02 s explicit, 0.2 s implicit.
void integrators(benchmark::State& state) {
  const solver::FlowSetup setup = developed_flow(0.005, 0.7, 1);
  const auto cost = [&](solver::Integrator integrator, double time) {
    solver::FlowSetup own = setup;
    own.numerics.integrator = integrator;
    solver::Flow flow(std::move(own));
    advance(flow, 5);
    const double start = flow.time();
    return measure([&] { advance_to(flow, start + time); }).cpu / time;
  };
  for ([[maybe_unused]] auto _ : state) {
    const double implicit = cost(solver::Integrator::implicit_viscosity, 0.2);
    const double reference = cost(solver::Integrator::rk4_explicit, 0.02);
    state.counters["speedup"] = reference / implicit;
    state.counters["implicit_s_per_s"] = implicit;
    state.counters["explicit_s_per_s"] = reference;
  }
}

// Two designs of 5 mm, 0.4 s of flow each.
void side_by_side(benchmark::State& state) {
  solver::RunOptions options;
  options.stop_time = 0.4;
  const auto one = [&] {
    solver::Result result = solver::simulate(h10_d45(), numerics_of(0.005), options);
    benchmark::DoNotOptimize(result);
  };
  for ([[maybe_unused]] auto _ : state) {
    std::vector<double> in_turn, together;
    for (int turn = 0; turn < 3; ++turn) {
      in_turn.push_back(measure([&] {
                          one();
                          one();
                        }).wall);
      together.push_back(measure([&] {
                           const std::jthread other(one);
                           one();
                         }).wall);
    }
    state.counters["speedup"] = *std::min_element(in_turn.begin(), in_turn.end()) /
                                *std::min_element(together.begin(), together.end());
  }
}

// Peak memory of a run from its set-up on, over the particles.
void memory_60k(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    reset_peak_resident();
    const double before = resident_bytes();
    solver::Flow flow(solver::channel_setup(h10_d45(), numerics_of(0.001), 1));
    advance(flow, 5);
    state.counters["bytes_per_particle"] = (peak_resident_bytes() - before) / flow.fluid().n;
    state.counters["particles"] = flow.fluid().n;
  }
}

}  // namespace
}  // namespace parapet::bench

int main(int argc, char** argv) {
  using namespace parapet::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const auto add = [](const char* name, void (*compare)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, compare)
        ->Unit(benchmark::kSecond)
        ->Iterations(1)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  };
  add("compare/memory_60k", memory_60k);  // first, before others have used memory
  add("compare/integrators", integrators);
  add("compare/side_by_side", side_by_side);
  add("compare/threads_60k", threads_60k);
  add("compare/size_60k", size_60k);
  benchmark::RunSpecifiedBenchmarks();
}
