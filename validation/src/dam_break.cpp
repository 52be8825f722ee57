// Dam break of water against a wall, held against the measurements of Lobovsky et al. (2014, J.
// Fluids Struct. 48:407-434): depths at four gauges, the front, pressures in the wall. The
// measured runs were repeated up to a hundred times; so are the simulated ones, from lattices with
// different offsets, and medians are compared.
#include <algorithm>
#include <iterator>
#include <utility>

#include "cases.hpp"
#include "dam_break_groups.hpp"

namespace parapet::validation {
namespace {

void compute(std::vector<Group>& groups, const Lobovsky& measured, CaseRun& run) {
  struct Task {
    Group* group;
    std::size_t k;
    DamBreak dam;
  };
  std::vector<Task> tasks;
  for (Group& g : groups) {
    for (std::size_t k = 0; k < g.runs.size(); ++k) {
      DamBreak dam = g.dam;
      dam.seed = static_cast<unsigned>(k + 1);
      if (k > 0) {
        dam.end = std::min(3.7, dam.end);
        dam.pictures.clear();
      }
      tasks.push_back({&g, k, dam});
    }
  }
  std::ranges::stable_sort(
      tasks, [](const Task& a, const Task& b) { return cost_of(a.dam) > cost_of(b.dam); });
  std::vector<double> costs;
  for (const Task& t : tasks) costs.push_back(cost_of(t.dam));
  run.side_by_side(
      tasks.size(),
      [&](std::size_t i) {
        tasks[i].group->runs[tasks[i].k] = simulated(tasks[i].dam, measured, run);
      },
      costs);
}

DamBreak dam(double depth, double spacing) {
  DamBreak d;
  d.depth = depth;
  d.spacing = spacing;
  return d;
}

Group group(const char* key, const char* name, const DamBreak& d, std::size_t repeats) {
  Group g{key, name, d};
  g.runs.resize(repeats);
  return g;
}

}  // namespace

void dam_break(CaseRun& run) {
  const Lobovsky m = read_lobovsky();
  std::vector<Group>
      groups;  // spacings from coarse to fine, the high dam, influences (no-slip first)
  std::size_t n_spacings = 0;
  if (run.full()) {
    groups.push_back(group("10", "10 mm", dam(0.3, 0.01), 4));
    groups.push_back(group("7_5", "7.5 mm", dam(0.3, 0.0075), 4));
    groups.push_back(group("5", "5 mm", dam(0.3, 0.005), 4));
    n_spacings = 3;
    groups.push_back(group("high", "10 mm", dam(0.6, 0.01), 3));
    groups.back().dam.end = 2.9;
    groups.push_back(group("no_slip", "7.5 mm, no-slip walls", dam(0.3, 0.0075), 3));
    groups.back().dam.slip = solver::WallSlip::no_slip;
    groups.push_back(group("alpha_0", "7.5 mm, no grid viscosity", dam(0.3, 0.0075), 3));
    groups.back().dam.alpha = 0.0;
    groups.push_back(group("alpha_2", "7.5 mm, grid viscosity doubled", dam(0.3, 0.0075), 3));
    groups.back().dam.alpha = 0.02;
    groups.push_back(group("sound", "7.5 mm, sound speed 1.5 times", dam(0.3, 0.0075), 3));
    groups.back().dam.sound_factor = 30.0;
  } else {
    groups.push_back(group("20", "20 mm", dam(0.3, 0.02), 1));
    groups.push_back(group("15", "15 mm", dam(0.3, 0.015), 1));
    n_spacings = 2;
    groups.push_back(group("high", "30 mm", dam(0.6, 0.03), 1));
    groups.back().dam.end = 2.9;
    groups.push_back(group("no_slip", "20 mm, no-slip walls", dam(0.3, 0.02), 1));
    groups.back().dam.slip = solver::WallSlip::no_slip;
  }
  groups[n_spacings - 2].dam.pictures = {1.0, 2.5, 3.0, 4.5, 6.0, 7.5};
  compute(groups, m, run);
  const std::vector<Group> spacings(
      std::make_move_iterator(groups.begin()),
      std::make_move_iterator(groups.begin() + std::ptrdiff_t(n_spacings)));
  const Group& no_slip = groups[n_spacings + 1];
  add_depths(run, spacings, no_slip, m);
  add_peaks(run, spacings, m);
  add_decay(run, spacings, no_slip, m);
  add_forces(run, spacings, m);
  add_high_dam(run, groups[n_spacings], m);
  std::vector<const Group*> influences;
  for (std::size_t k = n_spacings + 1; k < groups.size(); ++k) influences.push_back(&groups[k]);
  add_influences(run, influences, m);
  add_balances(run, spacings.back());
  draw_depths(run, spacings.back(), m);
  draw_pressures(run, spacings, no_slip, m);
  draw_flow(run, spacings[spacings.size() - 2]);
}

}  // namespace parapet::validation
