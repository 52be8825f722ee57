// Metrics of the flow at the first barrier's foot, or at the monitored place of an open channel.
#include <array>
#include <cmath>

#include "metric_entries.hpp"

namespace parapet::solver {
namespace {

using namespace metric_entries;

// Of the flow at the first barrier's foot, or at the monitored place of an open channel.
constexpr std::array channel_entries{
    MetricEntry{.key = "front_velocity_m_s",
                .unit = "m/s",
                .absent_when = {&front_not_seen},
                .definition =
                    "speed of the flow's front, which has front_mass_share (0.5 %) of the released "
                    "mass ahead, over front_base (0.5 H0): centred on the monitored place of an "
                    "open channel, ending front_clearance (0.75 H0) upstream of the first barrier",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {run.front.speed, front_not_seen};
                },
                .coarsest = [](Settings s) { return s.front_base_ratio / fewest_across_window; },
                .mass_share = [](Settings s) { return s.front_mass_share; }},
    MetricEntry{.key = "arrival_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {&front_not_seen},
                .definition = "time at which that front reaches the monitored place, or "
                              "front_clearance (0.75 H0) upstream of the first barrier",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {run.front.arrival, front_not_seen};
                },
                .mass_share = [](Settings s) { return s.front_mass_share; }},
    MetricEntry{.key = "flow_depth_max_m",
                .unit = "m",
                .least = 0.0,
                .absent_when = {&open_channel_only},
                .definition = "open channel: largest mean depth (mass over density and length) in "
                              "depth_window (0.2 H0) upstream of the monitored place",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.deepest, &DeepestFlow::depth), open_channel_only};
                },
                .coarsest = [](Settings s) { return s.depth_window_ratio / fewest_across_window; }},
    MetricEntry{.key = "flow_depth_max_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {&open_channel_only},
                .definition = "time of flow_depth_max_m",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.deepest, &DeepestFlow::time), open_channel_only};
                },
                .coarsest = [](Settings s) { return s.depth_window_ratio / fewest_across_window; }},
    MetricEntry{.key = "froude_number",
                .unit = "",
                .absent_when = {&open_channel_only, &not_reached},
                .definition = "front_velocity_m_s over the square root of g cos(slope) flow depth, "
                              "for an open channel",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  if (!run.deepest) return open_channel_only;
                  if (!run.front.speed || run.deepest->depth <= 0.0) return not_reached;
                  return *run.front.speed /
                         std::sqrt(run.gravity * std::cos(run.slope) * run.deepest->depth);
                },
                .coarsest = [](Settings s) { return s.depth_window_ratio / fewest_across_window; },
                .mass_share = [](Settings s) { return s.front_mass_share; }},
    MetricEntry{
        .key = "kinetic_energy_peak_j_per_m",
        .unit = "J/m",
        .least = 0.0,
        .absent_when = {&nothing_moved},
        .definition = "largest kinetic energy in energy_window (0.25 H0) either side of the first "
                      "foot, or of the monitored place (Eq. 16), no later than first_peak_time "
                      "(0.7 sqrt(H0/g)) after the flow met the first barrier",

        .gauge = [](Readings run, std::size_t) -> Reading {
          return {of(run.energy, &EnergyPhases::peak), nothing_moved};
        },
        .coarsest = [](Settings s) { return 2.0 * s.energy_window_ratio / fewest_across_window; }},
    MetricEntry{
        .key = "kinetic_energy_peak_time_s",
        .unit = "s",
        .least = 0.0,
        .absent_when = {&nothing_moved},
        .definition = "time of that peak, the end of the cumulative phase",

        .gauge = [](Readings run, std::size_t) -> Reading {
          return {of(run.energy, &EnergyPhases::peak_time), nothing_moved};
        },
        .coarsest = [](Settings s) { return 2.0 * s.energy_window_ratio / fewest_across_window; }},
    MetricEntry{
        .key = "kinetic_energy_minimum_j_per_m",
        .unit = "J/m",
        .least = 0.0,
        .absent_when = {&nothing_moved, &energy_only_falls},
        .definition = "energy in the window from which it rises again most, the depth of "
                      "the interaction phase",

        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.energy) return nothing_moved;
          return {of(run.energy->rise, &EnergyPhases::Rise::minimum), energy_only_falls};
        },
        .coarsest = [](Settings s) { return 2.0 * s.energy_window_ratio / fewest_across_window; }},
    MetricEntry{
        .key = "kinetic_energy_overflow_peak_j_per_m",
        .unit = "J/m",
        .least = 0.0,
        .absent_when = {&nothing_moved, &energy_only_falls},
        .definition = "energy to which it rises from there",

        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.energy) return nothing_moved;
          return {of(run.energy->rise, &EnergyPhases::Rise::overflow_peak), energy_only_falls};
        },
        .coarsest = [](Settings s) { return 2.0 * s.energy_window_ratio / fewest_across_window; }},
    MetricEntry{
        .key = "kinetic_energy_plateau_time_s",
        .unit = "s",
        .least = 0.0,
        .absent_when = {&nothing_moved, &still_moving},
        .definition = "time after which the window's kinetic energy stays below 5 % of its "
                      "largest value",

        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.energy) return nothing_moved;
          return {run.energy->plateau_time, still_moving};
        },
        .coarsest = [](Settings s) { return 2.0 * s.energy_window_ratio / fewest_across_window; }},
};

static_assert(complete(channel_entries), "every metric needs a key, a definition and a gauge");

}  // namespace

std::span<const MetricEntry> channel_metrics() {
  return channel_entries;
}

}  // namespace parapet::solver
