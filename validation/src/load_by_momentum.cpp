#include "load_by_momentum.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "barrier_runs.hpp"
#include "control_volume.hpp"
#include "parapet/flow/channel.hpp"

namespace parapet::validation {

using solver::Flow;
using solver::FlowSetup;

namespace {

// The design load of one barrier, from the load gauge and from the momentum of the flow around it.
ControlVolume::Mean load_by_momentum(const SingleBarrier& barrier, double spacing,
                                     const CaseRun& run) {
  const solver::Scene scene = scene_of(barrier);
  solver::Numerics numerics;
  numerics.spacing = spacing;
  FlowSetup setup = solver::channel_setup(scene, numerics, 1);
  // a fifth of H0 clear of the barrier: beyond the kernel's reach at every spacing tried here
  const ControlPlanes planes = planes_around(scene, spacing, 0.2 * scene.reservoir_height);
  with_control_volume(setup, planes);
  Flow flow(std::move(setup));
  ControlVolume volume(flow, planes);
  constexpr double end = 1.4, close = 1e-12;  // [s], after the largest mean
  while (end - flow.time() > close) {
    run.check_cancelled();
    if (const auto failure = flow.step(end - flow.time()))
      throw std::runtime_error(failure->reason);
    volume.add_step(flow);
  }
  const solver::GaugeSettings gauges;
  return volume.largest_mean(gauges.design_load_time_ratio * event_units(scene, gauges).time);
}

}  // namespace

void add_load_by_momentum(CaseRun& run) {
  const std::vector<SingleBarrier> barriers{{"wd2", "bare 100 mm", 0.1, bare},
                                            {"d0", "0 deg deflector", 0.1, 0.0},
                                            {"d45", "45 deg deflector", 0.1, 45.0}};
  const std::vector<double> spacings = run.full() ? std::vector{0.01, 0.005} : std::vector{0.0125};
  const std::size_t n_spacings = spacings.size();
  std::vector<ControlVolume::Mean> means(barriers.size() * n_spacings);
  std::vector<double> costs(means.size(), run.full() ? 10.0 : 1.0);
  run.side_by_side(
      means.size(),
      [&](std::size_t k) {
        means[k] = load_by_momentum(barriers[k / n_spacings], spacings[k % n_spacings], run);
      },
      costs);
  for (std::size_t k = 0; k < means.size(); ++k) {
    const SingleBarrier& barrier = barriers[k / n_spacings];
    const double spacing = spacings[k % n_spacings];
    const std::string of = fmt::format("{}, {:.3g} mm", barrier.name, 1e3 * spacing);
    const std::string key = fmt::format("load_{}_{:.0f}um", barrier.key, 1e6 * spacing);
    run.add({.key = key,
             .what = of + ": design force, of the load gauge",
             .value = norm(means[k].measured),
             .unit = "N/m"});
    run.add({.key = key + "_balance",
             .what = of + ": that force minus the one of the momentum balance around the barrier",
             .value = 100.0 * norm(means[k].measured - means[k].balance) / norm(means[k].measured),
             .unit = "%",
             .upper = 2.0,
             .reason = "vector, mean over 0.1 s: the gauge sums forces at wall points, the balance "
                       "momentum, flux and pair forces of the fluid; the tensile-instability "
                       "control acts on one of a pair alone"});
  }
}

}  // namespace parapet::validation
