// Depths, front and balances of the dam break against the measurements.
#include <fmt/format.h>

#include <algorithm>

#include "dam_break_groups.hpp"
#include "flow_tools.hpp"

namespace parapet::validation {
namespace {

// The gauges before the wave that comes back from the wall reaches them [t*], read off the data.
constexpr double before_return[4] = {8.0, 7.0, 6.5, 5.0};

double depth_difference(const DamBreakRecord& r, const Lobovsky& m, std::size_t gauge) {
  std::vector<double> computed, table;
  const MeasuredBand& band = m.levels[gauge].depth;
  for (std::size_t k = 0; k < band.t.size() && band.t[k] <= before_return[gauge]; ++k) {
    computed.push_back(r.depth[gauge].at(band.t[k]));
    table.push_back(band.middle[k]);
  }
  return rms_difference(computed, table);
}

double largest_depth_difference(const DamBreakRecord& r, const Lobovsky& m) {
  double largest = 0.0;
  for (std::size_t g = 0; g < 4; ++g) largest = std::max(largest, depth_difference(r, m, g));
  return largest;
}

// Arrival of the water at a gauge against the middle of the measured ones, whose clock is late.
double arrival_difference(const DamBreakRecord& r, const Lobovsky& m, std::size_t gauge,
                          double late) {
  const MeasuredLevel& level = m.levels[gauge];
  return r.depth[gauge].first_reaches(0.05) + late - 0.5 * (level.arrival_low + level.arrival_high);
}

double front_difference(const DamBreakRecord& r, const Lobovsky& m, double late) {
  std::vector<double> computed;
  for (const double t : m.front_t) computed.push_back(r.front.at(t - late));
  return rms_difference(computed, m.front_x);
}

}  // namespace

void add_depths(CaseRun& run, const std::vector<Group>& spacings, const Group& no_slip,
                const Lobovsky& m) {
  const Group& finest = spacings.back();
  for (std::size_t g = 0; g < 4; ++g) {
    run.add({.key = fmt::format("depth_{}", g + 1),
             .what = fmt::format("depth at H{}, {}: RMS difference, t* up to {:.1f}", g + 1,
                                 finest.name, before_return[g]),
             .value = depth_difference(finest.whole(), m, g),
             .upper = 0.05,
             .reason = "of the first depth; before the wave comes back from the wall"});
  }
  for (std::size_t k = 0; k + 1 < spacings.size(); ++k) {
    run.add({.key = fmt::format("depth_{}", spacings[k].key),
             .what = fmt::format("largest of these four at {}", spacings[k].name),
             .value = largest_depth_difference(spacings[k].whole(), m),
             .upper = 0.05,
             .reason = "as above",
             .explanation = "before the wave comes back to H3 the spray ahead of it, of single "
                            "particles at coarse spacings, disturbs the depth there"});
  }
  const double late = m.clock_difference(finest.dam.depth);
  run.add({.key = "clock",
           .what = "measured alone: front at the wall, by its last slope, minus rise of the "
                   "pressure there (t*)",
           .value = late});
  for (std::size_t g = 1; g < 4; ++g) {
    run.add(
        {.key = fmt::format("arrival_{}", g + 1),
         .what = fmt::format("arrival at H{} (depth 0.05), {}: computed minus measured, t*", g + 1,
                             finest.name),
         .value = arrival_difference(finest.whole(), m, g, 0.0),
         .lower = -0.1,
         .upper = 0.1,
         .reason = "the front moves 0.17 H in this time",
         .explanation = fmt::format(
             "no friction at the floor: with no-slip walls ({}) it is {:.3f}. Also the clock of "
             "the measured depths and fronts is {:.2f} behind that of the pressures, next row",
             no_slip.name, arrival_difference(no_slip.whole(), m, g, 0.0), late)});
    run.add({.key = fmt::format("arrival_{}_shifted", g + 1),
             .what = fmt::format("the same on the clock of the pressures"),
             .value = arrival_difference(finest.whole(), m, g, late),
             .lower = -0.1,
             .upper = 0.1,
             .reason = "as above"});
    run.add({.key = fmt::format("arrival_{}_no_slip", g + 1),
             .what = fmt::format("arrival at H{} as the paper set the case up, {}", g + 1,
                                 no_slip.name),
             .value = arrival_difference(no_slip.whole(), m, g, 0.0),
             .lower = -0.1,
             .upper = 0.1,
             .reason = "as above"});
  }
  run.add({.key = "front",
           .what = fmt::format("front, {}: RMS difference of x/H, measured clock", finest.name),
           .value = front_difference(finest.whole(), m, 0.0),
           .upper = 0.17,
           .reason = "0.1 in t* at the front's speed of 1.7 sqrt(g H)"});
  run.add({.key = "front_shifted",
           .what = "the same on the clock of the pressures",
           .value = front_difference(finest.whole(), m, late),
           .upper = 0.17,
           .reason = "as above",
           .explanation = "early on the measured front is ahead of an instant release (the gate "
                          "opens at the floor first), later behind it: no single shift fits both"});
  run.add(
      {.key = "front_speed",
       .what = fmt::format("speed of the front over sqrt(g H), {}, t* = 1.4 to 2.2", finest.name),
       .value = (finest.whole().front.at(2.2) - finest.whole().front.at(1.4)) / 0.8});
  const Series table{m.front_t, m.front_x};
  run.add({.key = "front_speed_measured",
           .what = "the same, measured",
           .value = (table.at(2.2) - table.at(1.4)) / 0.8});
}

void add_influences(CaseRun& run, const std::vector<const Group*>& groups, const Lobovsky& m) {
  for (const Group* g : groups) {
    const double window = rise_window(m, g->dam.depth);
    const auto add = [&](const char* key, const char* what, double value) {
      run.add({.key = fmt::format("{}_{}", g->key, key),
               .what = fmt::format("{}: {}", g->name, what),
               .value = value});
    };
    add("depths", "largest RMS difference of the depths", largest_depth_difference(g->whole(), m));
    add("arrival", "arrival at H4, computed minus measured",
        arrival_difference(g->whole(), m, 3, 0.0));
    for (std::size_t s = 0; s < 2; ++s) {
      add(s == 0 ? "peak_1" : "peak_2", s == 0 ? "peak at sensor 1" : "peak at sensor 2",
          g->median([&](const DamBreakRecord& r) { return r.peak(s, window); }));
    }
    add("decay", "RMS difference of sensor 2 from the measured median",
        decay_difference(g->whole(), m));
    add("plateau", "mean pressure at sensor 2, t* = 4 to 5",
        g->whole().pressure[1].integral(4.0, 5.0));
  }
}

void add_balances(CaseRun& run, const Group& finest) {
  const DamBreakRecord& r = finest.whole();
  run.add({.key = "mass",
           .what = fmt::format("{}, whole run: change of the mass", finest.name),
           .value = r.balance->mass_change(*r.flow),
           .lower = -1e-12,
           .upper = 1e-12,
           .reason = "particles exchange equal and opposite masses; rounding of the sum"});
  run.add({.key = "momentum",
           .what = fmt::format("{}, whole run: momentum not explained by gravity and wall forces",
                               finest.name),
           .value = 100.0 * r.balance->momentum_error(*r.flow),
           .unit = "%",
           .upper = 1.0,
           .reason =
               "share of the impulse of gravity; pair forces (except those of the "
               "tensile-instability control) and what shifting exchanges are equal and opposite"});
  run.add(
      {.key = "energy_before",
       .what = fmt::format("{}, before the impact: energy lost but not dissipated by viscosity, "
                           "share of what the dam has above the state at rest",
                           finest.name),
       .value = 100.0 * r.loss_before_impact,
       .unit = "%",
       .lower = -0.5,
       .upper = 2.0,
       .reason = "no breaking yet: density diffusion and shifting must take little energy and give "
                 "none"});
  run.add({.key = "energy_end",
           .what = "the same at t* = 8, after impact and breaking",
           .value = 100.0 * r.loss_at_end,
           .unit = "%"});
  run.add({.key = "energy_viscous",
           .what = "dissipated by the grid's viscosity until then",
           .value = 100.0 * r.viscous_at_end,
           .unit = "%"});
}

}  // namespace parapet::validation
