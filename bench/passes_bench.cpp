// Each neighbour sum alone, on one core, for every instruction set that this machine has: directed
// pairs within the kernel's reach per second, and what that is in arithmetic and in traffic.
// Names: pass/STATE/INSTRUCTION SET/PASS.
#include <benchmark/benchmark.h>

#include <functional>
#include <memory>

#include "parapet/flow/stage_timer.hpp"
#include "pass_cost.hpp"
#include "states.hpp"

namespace parapet::bench {
namespace {

using solver::FlowArrays;
using solver::PassTable;

// A state with everything that the passes read and room for what they write.
struct Subject {
  explicit Subject(solver::FlowSetup setup) : flow(std::move(setup)) {
    advance(flow, 3);
    flow.evaluate();
    arrays = flow.arrays();
    pairs = solver::count_pairs(arrays);
    n = flow.fluid().n;
    const auto size = static_cast<std::size_t>(n) + 1;
    std::int32_t slots = 0;
    for (int g = 0; g < solver::groups_of(n); ++g) {
      matrix_begin.push_back(slots);
      slots += arrays.rows.wall_begin[g] - arrays.rows.begin[g];
    }
    strength.assign(static_cast<std::size_t>(slots), 0.0F);
    for (auto& a : particle) a.assign(size, 0.0);
    for (auto& a : wall) a.assign(static_cast<std::size_t>(arrays.rows.n_active) + 1, 0.0);
    sums = solver::GradientSumArrays(n);
    viscous = {strength.data(),
               matrix_begin.data(),
               particle[0].data(),
               particle[1].data(),
               particle[2].data(),
               particle[3].data(),
               particle[4].data(),
               particle[5].data(),
               particle[6].data(),
               particle[7].data(),
               1.4e-4};
    solver::best_passes().viscous_matrix(arrays, viscous, 0, n);
    vector.assign(arrays.fluid.motion, arrays.fluid.motion + size);
  }

  solver::ShiftedRates rates() {
    return {particle[8].data(), particle[9].data(), particle[10].data(), particle[11].data()};
  }

  solver::Flow flow;
  FlowArrays arrays;
  solver::PairCount pairs;
  int n = 0;
  solver::GradientSumArrays sums{0};
  std::vector<float> strength;
  std::vector<std::int32_t> matrix_begin;
  std::vector<double> particle[12], wall[2];
  std::vector<solver::MotionRecord> vector;
  solver::ViscousView viscous;
};

struct Pass {
  const char* name;
  std::function<void(const PassTable&, Subject&)> run;
};

const std::vector<Pass>& passes() {
  static const std::vector<Pass> all = {
      {"pressure_force",
       [](const PassTable& p, Subject& s) {
         p.pressure_force(s.arrays, s.particle[8].data(), s.particle[9].data(), 0, s.n);
       }},
      {"density_rate",
       [](const PassTable& p, Subject& s) { p.density_rate(s.arrays, s.rates(), 0, s.n); }},
      {"pressure_and_continuity",
       [](const PassTable& p, Subject& s) {
         p.pressure_force(s.arrays, s.particle[8].data(), s.particle[9].data(), 0, s.n);
         p.density_rate(s.arrays, s.rates(), 0, s.n);
       }},
      {"gradient_sums",
       [](const PassTable& p, Subject& s) { p.gradient_sums(s.arrays, s.sums.view, 0, s.n); }},
      {"viscous_force",
       [](const PassTable& p, Subject& s) {
         p.viscous_force(s.arrays, s.particle[8].data(), s.particle[9].data(), 0, s.n);
       }},
      {"viscous_matrix",
       [](const PassTable& p, Subject& s) { p.viscous_matrix(s.arrays, s.viscous, 0, s.n); }},
      {"viscous_product",
       [](const PassTable& p, Subject& s) {
         p.viscous_product(s.arrays, s.viscous, s.vector.data(), s.particle[8].data(),
                           s.particle[9].data(), 0, s.n);
       }},
      {"extrapolate_walls",
       [](const PassTable& p, Subject& s) {
         p.extrapolate_walls(s.arrays, 0, s.arrays.rows.n_active);
       }},
      {"wall_load",
       [](const PassTable& p, Subject& s) {
         p.wall_load(s.arrays, s.wall[0].data(), s.wall[1].data(), 0, s.arrays.rows.n_active);
       }},
  };
  return all;
}

void count(benchmark::State& state, const Subject& s, const PassCost& cost) {
  using benchmark::Counter;
  const auto fluid = cost.fluid_bytes > 0.0 ? static_cast<double>(s.pairs.fluid) : 0.0;
  const auto wall = cost.wall_bytes > 0.0 ? static_cast<double>(s.pairs.wall) : 0.0;
  const double calls = static_cast<double>(state.iterations()), pairs = fluid + wall;
  const double flops = fluid * cost.fluid_flops + wall * cost.wall_flops;
  const double bytes = fluid * cost.fluid_bytes + wall * cost.wall_bytes;
  const double slots = static_cast<double>(s.pairs.slots) * pairs /
                       static_cast<double>(s.pairs.fluid + s.pairs.wall);
  const double streamed = cost.slot_bytes * slots + cost.particle_bytes * s.n;
  auto& c = state.counters;
  c["pairs_per_s"] = Counter(pairs * calls, Counter::kIsRate);
  c["flop_per_s"] = Counter(flops * calls, Counter::kIsRate);
  c["requested_bytes_per_s"] = Counter(bytes * calls, Counter::kIsRate);
  c["streamed_bytes_per_s"] = Counter(streamed * calls, Counter::kIsRate);
  // values fetched by index, for the lanes outside the kernel's reach too
  const double gathers = (bytes / pairs - cost.slot_bytes) / sizeof(double);
  c["gathers_per_s"] = Counter(gathers * slots * calls, Counter::kIsRate);
  c["flops_per_pair"] = flops / pairs;
  c["bytes_per_pair"] = bytes / pairs;
  c["streamed_bytes_per_pair"] = streamed / pairs;
  c["neighbors"] = pairs / s.n;
  c["slots_per_pair"] = slots / pairs;
}

void add(const std::string& state_name, const std::shared_ptr<Subject>& subject, bool walls) {
  for (const char* isa : {"x86_64", "x86_64_v3", "x86_64_v4"}) {
    const PassTable* table = solver::find_passes(isa);
    if (table == nullptr) continue;
    for (const Pass& pass : passes()) {
      const PassCost& cost = pass_cost(pass.name);
      if (!walls && cost.fluid_bytes == 0.0) continue;
      const std::string name = "pass/" + state_name + "/" + isa + "/" + pass.name;
      benchmark::RegisterBenchmark(name.c_str(), [=, &pass](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) {
          pass.run(*table, *subject);
          benchmark::ClobberMemory();
        }
        count(state, *subject, pass_cost(pass.name));
      })->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace
}  // namespace parapet::bench

int main(int argc, char** argv) {
  using namespace parapet::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  add("flow", std::make_shared<Subject>(developed_flow(0.005, 0.7, 1)), true);
  add("box", std::make_shared<Subject>(box(100)), false);
  benchmark::RunSpecifiedBenchmarks();
}
