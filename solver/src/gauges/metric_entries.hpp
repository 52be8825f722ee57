// What the tables of metrics share: ranges, reasons of absence, and short names.
#pragma once

#include <algorithm>
#include <numbers>
#include <optional>
#include <span>

#include "metric_table.hpp"

namespace parapet::solver {

// The tables: of the overflow over the first barrier; of the flow at its foot, or at the monitored
// place of an open channel; of every barrier.
std::span<const MetricEntry> overflow_metrics();
std::span<const MetricEntry> channel_metrics();
std::span<const MetricEntry> barrier_metrics();

namespace metric_entries {

using Readings = const RunReadings&;
using Settings = const GaugeSettings&;

inline constexpr double degree = std::numbers::pi / 180.0;

inline double one(Readings) {
  return 1.0;
}
inline double released_volume(Readings run) {
  return run.released_volume;
}

inline constexpr Absent front_not_seen{.text = "the front was not seen passing there",
                                       .may_come = true};
inline constexpr Absent open_channel_only{
    .text = "gauged in an open channel only: here the barrier backs the flow up"};
inline constexpr Absent not_reached{.text = "not reached in this run", .may_come = true};
inline constexpr Absent nothing_moved{.text = "nothing moved through the window", .may_come = true};
inline constexpr Absent energy_only_falls{.text = "the energy only falls after its first peak",
                                          .may_come = true};
inline constexpr Absent still_moving{.text = "the window was still moving at the end",
                                     .may_come = true};
inline constexpr Absent nothing_landed{
    .text = "less than impact_mass_share of the released mass landed beyond the first barrier",
    .may_come = true};
inline constexpr Absent no_deflector{.text = "the first barrier has no deflector"};
inline constexpr Absent did_not_pass_edge{
    .text = "what landed first had not passed over the first barrier's last edge"};
inline constexpr Absent little_passed{.text =
                                          "less than impact_mass_share of the released mass passed "
                                          "over the first barrier's last edge",
                                      .may_come = true};
inline constexpr Absent no_dead_zone{.text = "no dead zone as long as one column formed",
                                     .may_come = true};
inline constexpr Absent no_backflow{
    .text = "less than impact_mass_share of the released mass flowed back at once",
    .may_come = true};
inline constexpr Absent no_ramp_held{.text = "the debris did not reach over the whole ramp"};
inline constexpr Absent no_force{.text = "no force acted on the barrier", .may_come = true};
inline constexpr Absent never_near{.text =
                                       "arrival_mass_share of the released mass was never within "
                                       "arrival_window of the line at once",
                                   .may_come = true};

inline constexpr Absent no_push{.text = "the design force does not push the stem downstream",
                                .may_come = true};
inline constexpr Absent not_at_rest{
    .text = "read at rest only: the run was not until_rest, or it ended before",
    .kind = Absence::run_too_short};
inline constexpr Absent no_approach{
    .text =
        "the undisturbed flow at the barrier was not given: `simulate --approach`, a study, or "
        "`approach` in the case"};
inline constexpr Absent approach_not_seen{
    .text = "the undisturbed flow does not come as far as the barrier"};
inline constexpr Absent no_reading_time{.text = "no run.reading_time_s was given"};
inline constexpr Absent nothing_beyond{
    .text = "nothing was beyond the first barrier at run.reading_time"};
inline constexpr Absent no_ramp{
    .text = "at run.reading_time the debris did not reach over the whole ramp"};

inline constexpr Absent ended_before_reading{.text = "the run ended before run.reading_time",
                                             .kind = Absence::run_too_short};
inline constexpr Absent impulse_cut_off{.text = "the run ended before impulse_time was over",
                                        .kind = Absence::run_too_short};

// A member of a reading that may not exist.
template <typename Owner, typename Value>
std::optional<double> of(const std::optional<Owner>& owner, Value Owner::*member) {
  return owner ? std::optional<double>((*owner).*member) : std::nullopt;
}

constexpr bool complete(std::span<const MetricEntry> entries) {
  return std::ranges::all_of(entries, [](const MetricEntry& entry) {
    return entry.gauge != nullptr && !entry.key.empty() && !entry.definition.empty();
  });
}

}  // namespace metric_entries
}  // namespace parapet::solver
