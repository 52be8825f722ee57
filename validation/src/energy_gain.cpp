// Thin fluid against a barrier with a deflector: no scheme may give energy. Kinetic and potential
// energy can only fall until something leaves; how far they rise, for several viscosities and
// spacings, shows up to which cell Reynolds number the answer holds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "barrier_runs.hpp"
#include "cases.hpp"

namespace parapet::validation {
namespace {

constexpr SingleBarrier barrier{"d45", "H10-D45", 0.1, 45.0};
constexpr double density = 1000.0;  // [kg/m3]
constexpr double speed = 3.5;       // with which it meets the barrier [m/s]

// What a suspected cause looks like when it is switched off.
struct Way {
  const char* key;
  const char* name;
  void (*change)(solver::Numerics&);
  bool open = false;  // without the barrier
};
constexpr Way ways[] = {
    {"as_is", "as it is", [](solver::Numerics&) {}},
    {"no_shifting", "no shifting", [](solver::Numerics& n) { n.shifting_factor = 0.0; }},
    {"short_steps", "a quarter of the time step",
     [](solver::Numerics& n) { n.cfl_acoustic = 0.25; }},
    {"stiff", "twice the sound speed", [](solver::Numerics& n) { n.sound_speed = 70.0; }},
    {"rk4", "rk4_explicit",
     [](solver::Numerics& n) { n.integrator = solver::Integrator::rk4_explicit; }},
    {"open", "no barrier", [](solver::Numerics&) {}, true},
    {"open_wide", "no barrier, h = 2 dx", [](solver::Numerics& n) { n.smoothing_ratio = 2.0; },
     true},
};

struct Group {
  double spacing;    // [m]
  double viscosity;  // [Pa s]
  const Way* way;
  std::vector<double> gains;  // one for each lattice
};

double gain(const Group& group, std::size_t lattice, const CaseRun& run) {
  solver::Scene scene = scene_of(barrier);
  if (group.way->open) scene.barriers.clear();
  scene.material = {};
  scene.material.density = density;
  scene.material.yield_stress = 0.0;
  scene.material.consistency = group.viscosity;
  scene.material.flow_index = 1.0;
  solver::Numerics numerics;
  numerics.spacing = group.spacing;
  numerics.lattice_jitter = 0.05;
  numerics.lattice_seed = static_cast<unsigned>(lattice + 1);
  group.way->change(numerics);
  solver::RunOptions options;
  options.stop_time = 0.8;  // the impact is over
  return simulated(scene, numerics, options, run).quality.energy_gain_ratio;
}

std::vector<Group> groups(bool full) {
  std::vector<Group> list;
  const auto add = [&](double spacing, double viscosity, const Way& way, std::size_t lattices) {
    list.push_back({spacing, viscosity, &way, std::vector<double>(lattices)});
  };
  for (const double viscosity : {1e-6, 0.1, 0.3, 1.0, 3.0}) {
    if (full) add(0.005, viscosity, ways[0], 2);
    if (full) add(0.01, viscosity, ways[0], 4);
    add(0.02, viscosity, ways[0], full ? 4 : 2);
  }
  if (full) {
    for (std::size_t k = 1; k < std::size(ways); ++k) add(0.02, 1e-6, ways[k], 4);
  }
  return list;
}

}  // namespace

void energy_gain(CaseRun& run) {
  std::vector<Group> list = groups(run.full());
  std::vector<std::pair<std::size_t, std::size_t>> tasks;
  std::vector<double> costs;
  for (std::size_t g = 0; g < list.size(); ++g) {
    for (std::size_t k = 0; k < list[g].gains.size(); ++k) {
      tasks.emplace_back(g, k);
      costs.push_back(0.3 * std::pow(0.02 / list[g].spacing, 3.0));
    }
  }
  run.side_by_side(
      tasks.size(),
      [&](std::size_t t) {
        const auto [g, k] = tasks[t];
        list[g].gains[k] = gain(list[g], k, run);
      },
      costs);
  for (const Group& g : list) {
    const double cell = density * speed * g.spacing / g.viscosity;
    Measure row{
        .key = fmt::format("{:.0f}mm_{}_{}", 1e3 * g.spacing, g.viscosity, g.way->key),
        .what = fmt::format("{:.0f} mm, {} Pa s (cell Reynolds number {:.2g}), {}: largest "
                            "gain of {} lattices",
                            1e3 * g.spacing, g.viscosity, cell, g.way->name, g.gains.size()),
        .value = 100.0 * *std::ranges::max_element(g.gains),
        .unit = "%"};
    if (g.way == &ways[0]) {
      row.upper = 100.0 * solver::QualityLimits::energy_gain_ratio;
      row.reason = "of the block's potential energy; where a result warns";
      row.explanation =
          "the impact of a sheet of two particles: without the barrier there is no gain (last "
          "rows), and twice as fine the limit is met";
    }
    run.add(row);
  }
}

}  // namespace parapet::validation
