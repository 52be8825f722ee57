// One design: build a scene, simulate it, read what was held back.
//
//   one_design [SPACING_MM]     particle spacing; 20 mm (coarse, a second) unless given
//
// Link parapet::solver, which needs nothing but OpenMP. Everything inside Parapet is in SI units
// and radians.
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "parapet/solver/simulation.hpp"

namespace solver = parapet::solver;

// The scene is the flume of the source paper: a channel of 26 degrees, in which a block of debris,
// 300 mm long and 200 mm deep, is let go. These are the defaults; only the barrier is ours.
static solver::Scene flume_with_one_barrier() {
  solver::Scene scene;

  solver::Barrier barrier;
  barrier.foot_x = 1.1;   // 1.1 m down the channel from the gate
  barrier.height = 0.10;  // a stem of 100 mm, upright
  barrier.deflector = solver::Deflector{.angle = 45.0 * std::numbers::pi / 180.0, .length = 0.065};
  scene.barriers.push_back(barrier);
  return scene;
}

static void print_metrics(const solver::Result& result) {
  std::printf("\nmetrics\n");
  for (const solver::Metric& metric : result.metrics) {
    if (metric.value) {
      std::printf("  %-40s %12.5g\n", metric.key.c_str(), *metric.value);
    } else {
      // A metric may have no value: nothing can land where nothing was launched.
      std::printf("  %-40s %12s  (%s)\n", metric.key.c_str(), "-", metric.absent_reason.c_str());
    }
  }
}

// Every kilogram that was released is still in the channel or has left it at the lower end.
static void print_mass(const solver::MassBalance& mass) {
  std::printf("\nmass per metre of width\n");
  std::printf("  released_kg_m    %10.4f\n", mass.released);
  std::printf("  in_channel_kg_m  %10.4f\n", mass.in_domain);
  std::printf("  left_kg_m        %10.4f\n", mass.left_domain);
}

int main(int argc, char** argv) try {
  const solver::Scene scene = flume_with_one_barrier();

  // The particle spacing decides accuracy and cost: half the spacing is about eight times the work.
  solver::Numerics numerics;
  numerics.spacing = (argc > 1 ? std::atof(argv[1]) : 20.0) / 1000.0;

  // The answer is the same to the bit for any number of threads.
  solver::RunOptions options;
  options.threads = 2;

  // simulate() throws only for input that makes no sense. A run that goes wrong is a result too.
  const solver::Result result = solver::simulate(scene, numerics, options);
  std::printf("status %s, stopped at %.2f s of simulated time: %s\n",
              std::string(to_string(result.status)).c_str(), result.stop_time,
              std::string(to_string(result.stop_reason)).c_str());
  if (result.status != solver::Status::ok) {
    std::printf("%s\n", result.reason.c_str());
    return 1;
  }

  print_metrics(result);
  print_mass(result.mass);

  // One metric by its name: the share of the released mass that stayed upstream of the barrier.
  if (const solver::Metric* held = result.find_metric("retention_efficiency");
      held && held->value) {
    std::printf("\nThe barrier held back %.1f %%.\n", 100.0 * *held->value);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
