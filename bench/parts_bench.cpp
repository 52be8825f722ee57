// What a step does beside the neighbour sums, on the flow of H10-D45 at 5 mm after 0.7 s, on one
// core. Names: part/WHAT. The time is that of one call for all particles.
#include <benchmark/benchmark.h>

#include "parapet/flow/rheology.hpp"
#include "parapet/flow/shifting.hpp"
#include "states.hpp"

namespace parapet::bench {
namespace {

using benchmark::Counter;

struct Subject {
  Subject() : flow(developed_flow(0.005, 0.7, 1)) {
    advance(flow, 3);
    flow.evaluate();
  }
  solver::Flow flow;
};

void per_particle(benchmark::State& state, int n) {
  state.counters["per_particle"] =
      Counter(n * static_cast<double>(state.iterations()), Counter::kIsRate | Counter::kInvert);
}

// Rows of their own: a flow does not let go of its.
struct OwnRows {
  explicit OwnRows(const Subject& s)
      : setup(s.flow.setup()),
        h(s.flow.smoothing_length()),
        walls(solver::lay_out_walls(setup.solids, setup.numerics.spacing, 2.0 * h)),
        rows(setup.solids, walls, 2.0 * h, setup.numerics.skin_ratio * h, setup.numerics.spacing,
             0.0),
        fluid(s.flow.fluid()) {
    rows.build(fluid, 1);
  }
  const solver::FlowSetup& setup;
  double h;
  solver::WallPoints walls;
  solver::NeighborRows rows;
  solver::Fluid fluid;
};

void neighbor_rows(benchmark::State& state, const Subject& s) {
  OwnRows own(s);
  for ([[maybe_unused]] auto _ : state) own.rows.build(own.fluid, 1);
  per_particle(state, own.fluid.n);
}

void neighbor_check(benchmark::State& state, const Subject& s) {
  const OwnRows own(s);
  for ([[maybe_unused]] auto _ : state) {
    bool outdated = own.rows.outdated(own.fluid);
    benchmark::DoNotOptimize(outdated);
  }
  per_particle(state, own.fluid.n);
}

void finish_gradients(benchmark::State& state, Subject& s) {
  const solver::GradientSumArrays sums = s.flow.gradient_sums();
  solver::Fluid fluid = std::as_const(s.flow).fluid();
  const solver::ShiftingSettings settings{s.flow.smoothing_length(), 2.0, 1.0, true, 0.0};
  for ([[maybe_unused]] auto _ : state) {
    solver::finish_gradients(fluid, sums.view, settings, s.flow.setup().material, 0, fluid.n);
  }
  per_particle(state, fluid.n);
}

void rheology(benchmark::State& state, const Subject& s) {
  const solver::Fluid& fluid = s.flow.fluid();
  std::vector<double> viscosity(fluid.shear_rate.size());
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < viscosity.size(); ++i) {
      viscosity[i] = solver::apparent_viscosity(s.flow.setup().material, fluid.shear_rate[i]);
    }
    benchmark::ClobberMemory();
  }
  per_particle(state, fluid.n);
}

// From the velocity before the step as the guess: more iterations than in a run, which
// extrapolates.
void viscous_solve(benchmark::State& state, Subject& s) {
  const solver::Fluid& fluid = s.flow.fluid();
  const double dt = s.flow.last_time_step();
  std::vector<double> u_star(fluid.u.size(), 0.0), w_star = u_star, u, w;
  s.flow.add_body_and_pressure_force(u_star, w_star);
  for (std::size_t i = 0; i < u_star.size(); ++i) {
    u_star[i] = fluid.u[i] + dt * u_star[i];
    w_star[i] = fluid.w[i] + dt * w_star[i];
  }
  const std::int64_t before = s.flow.statistics().cg_iterations;
  for ([[maybe_unused]] auto _ : state) {
    u = fluid.u;
    w = fluid.w;
    s.flow.solve_viscosity(u_star, w_star, u, w, dt);
  }
  per_particle(state, fluid.n);
  state.counters["cg_iterations"] = Counter(
      static_cast<double>(s.flow.statistics().cg_iterations - before), Counter::kAvgIterations);
}

}  // namespace
}  // namespace parapet::bench

int main(int argc, char** argv) {
  using namespace parapet::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Subject subject;
  const auto add = [&](const char* name, auto* part) {
    benchmark::RegisterBenchmark(name, [part, &subject](benchmark::State& state) {
      part(state, subject);
    })->Unit(benchmark::kMicrosecond);
  };
  add("part/neighbor_rows", neighbor_rows);
  add("part/neighbor_check", neighbor_check);
  add("part/finish_gradients", finish_gradients);
  add("part/rheology", rheology);
  add("part/viscous_solve", viscous_solve);
  benchmark::RunSpecifiedBenchmarks();
}
