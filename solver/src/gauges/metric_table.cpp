#include "metric_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace parapet::solver {
namespace {

using Readings = const RunReadings&;

constexpr double degree = std::numbers::pi / 180.0;

double one(Readings) {
  return 1.0;
}
double released_volume(Readings run) {
  return run.released_volume;
}
double way_to_barrier(Readings run) {
  return run.first_foot_x;
}
double deflectors_to_barrier(Readings run) {
  return run.first_foot_x / run.deflector_length.value_or(run.first_foot_x);
}

constexpr std::string_view front_not_seen = "the front was not seen passing there";
constexpr std::string_view open_channel_only =
    "gauged in an open channel only: here the barrier backs the flow up";
constexpr std::string_view not_reached = "not reached in this run";
constexpr std::string_view nothing_moved = "nothing moved through the window";
constexpr std::string_view energy_only_falls = "the energy only falls after its first peak";
constexpr std::string_view still_moving = "the window was still moving at the end";
constexpr std::string_view nothing_landed =
    "less than 0.5 % of the released mass landed beyond the first barrier";
constexpr std::string_view no_deflector = "the first barrier has no deflector";
constexpr std::string_view did_not_pass_edge =
    "what landed first had not passed over the first barrier's last edge";
constexpr std::string_view no_force = "no force on the barrier was measured over 5 ms";
constexpr std::string_view never_near =
    "0.5 % of the released mass was never within 20 mm upstream of the barrier's line at once";

// A member of a reading that may not exist.
template <typename Owner, typename Value>
std::optional<double> of(const std::optional<Owner>& owner, Value Owner::*member) {
  return owner ? std::optional<double>((*owner).*member) : std::nullopt;
}

// Ng et al. 2023: launch at angle b above the horizontal with speed v from height H over the bed.
double ballistic_distance(Readings run, const LaunchGauge::Launch& launch) {
  const double a = run.slope, g = run.gravity;
  const double vn = launch.speed * std::sin(a + launch.angle);
  const double vs = launch.speed * std::cos(a + launch.angle);
  const double t =
      (vn + std::sqrt(vn * vn + 2.0 * g * launch.height * std::cos(a))) / (g * std::cos(a));
  return vs * t + 0.5 * g * std::sin(a) * t * t;
}

std::string_view why_no_launch(Readings run) {
  return run.impact ? did_not_pass_edge : nothing_landed;
}

// Of the overflow over the first barrier.
constexpr std::array with_barrier{
    MetricEntry{
        .key = "retention_efficiency",
        .unit = "",
        .least = 0.0,
        .greatest = 1.0,
        .definition =
            "mass upstream of the first barrier's line over the mass released (Eq. 17), at the end",
        .gauge = [](Readings run, std::size_t) -> Reading { return run.barriers.front().retained; },
        .range = one},
    MetricEntry{
        .key = "retention_efficiency_total",
        .unit = "",
        .least = 0.0,
        .greatest = 1.0,
        .definition = "mass upstream of the last barrier's line over the mass released, at the end",
        .gauge = [](Readings run, std::size_t) -> Reading { return run.barriers.back().retained; },
        .range = one},
    MetricEntry{
        .key = "launch_length_m",
        .unit = "m",
        .absent_when = {nothing_landed},
        .definition =
            "distance along the bed from the first barrier's foot to the place where the coherent "
            "overflow (the first 1 % of the released mass to land) touches down, mass median",
        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.impact) return nothing_landed;
          return run.impact->x - run.first_foot_x;
        }},
    MetricEntry{.key = "impact_x_m",
                .unit = "m",
                .absent_when = {nothing_landed},
                .definition = "the same place, counted from the reservoir's back wall",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.impact, &LaunchGauge::Impact::x), nothing_landed};
                }},
    MetricEntry{.key = "impact_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {nothing_landed},
                .definition = "time at which 0.5 % of the released mass has landed",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.impact, &LaunchGauge::Impact::time), nothing_landed};
                }},
    MetricEntry{.key = "landing_speed_m_s",
                .unit = "m/s",
                .least = 0.0,
                .absent_when = {nothing_landed},
                .definition = "mean speed of that mass when 20 mm above the bed",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.impact, &LaunchGauge::Impact::landing_speed), nothing_landed};
                }},
    MetricEntry{
        .key = "launch_angle_deg",
        .unit = "deg",
        .absent_when = {nothing_landed, did_not_pass_edge},
        .definition =
            "direction of the momentum of that mass when it passed the first barrier's last edge "
            "(a deflector's tip, or the crest), against the world's horizontal",
        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.launch) return why_no_launch(run);
          return run.launch->angle / degree;
        }},
    MetricEntry{.key = "launch_speed_m_s",
                .unit = "m/s",
                .least = 0.0,
                .absent_when = {nothing_landed, did_not_pass_edge},
                .definition = "speed of that mean momentum",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.launch, &LaunchGauge::Launch::speed), why_no_launch(run)};
                }},
    MetricEntry{
        .key = "ballistic_launch_length_m",
        .unit = "m",
        .absent_when = {nothing_landed, did_not_pass_edge},
        .definition =
            "hand formula (Ng et al. 2023) for a launch with that speed and angle from the mean "
            "place of the passage, a cross-check of launch_length_m",
        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.launch) return why_no_launch(run);
          return run.launch->x - run.first_foot_x + ballistic_distance(run, *run.launch);
        }},
    MetricEntry{
        .key = "dead_zone_length_m",
        .unit = "m",
        .least = 0.0,
        .definition =
            "length along the bed, from the first barrier's foot upstream, over which more "
            "material is at rest (slower than 0.1 m/s) than the bed alone can hold, deeper than "
            "1.25 tau_y/(rho g sin slope) (20 to 100 mm), when the overflow lands (or at the end)",
        .gauge = [](Readings run, std::size_t) -> Reading { return run.dead_zone_length; },
        .range = way_to_barrier},
    MetricEntry{.key = "dead_zone_ratio",
                .unit = "",
                .least = 0.0,
                .absent_when = {no_deflector},
                .definition = "dead_zone_length_m over the deflector's length (D_F)",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  if (!run.deflector_length) return no_deflector;
                  return run.dead_zone_length / *run.deflector_length;
                },
                .range = deflectors_to_barrier},
    MetricEntry{.key = "overflow_volume_m3_per_m",
                .unit = "m3/m",
                .least = 0.0,
                .definition = "volume that has crossed the first barrier's line",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return (1.0 - run.barriers.front().retained) * run.released_volume;
                },
                .range = released_volume},
    MetricEntry{.key = "peak_overflow_discharge_m2_s",
                .unit = "m2/s",
                .least = 0.0,
                .definition = "largest discharge over that line, mean of 20 ms (or of the series "
                              "interval, when longer)",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return run.peak_loss_rate * run.released_volume;
                }},
};

// Of the flow at the first barrier's foot, or at the monitored place of an open channel.
constexpr std::array every_run{
    MetricEntry{.key = "front_velocity_m_s",
                .unit = "m/s",
                .absent_when = {front_not_seen},
                .definition =
                    "speed of the flow's front, which has 0.5 % of the released mass ahead, over "
                    "0.1 m: centred on the monitored place of an open channel, ending 0.15 m "
                    "upstream of the first barrier",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {run.front.speed, front_not_seen};
                }},
    MetricEntry{.key = "arrival_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {front_not_seen},
                .definition =
                    "time at which that front reaches the monitored place, or 0.15 m upstream of "
                    "the first barrier",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {run.front.arrival, front_not_seen};
                }},
    MetricEntry{.key = "flow_depth_max_m",
                .unit = "m",
                .least = 0.0,
                .absent_when = {open_channel_only},
                .definition = "open channel: largest mean depth (mass over density and length) in "
                              "the 40 mm upstream of the monitored place",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.deepest, &DeepestFlow::depth), open_channel_only};
                }},
    MetricEntry{.key = "flow_depth_max_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {open_channel_only},
                .definition = "time of flow_depth_max_m",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.deepest, &DeepestFlow::time), open_channel_only};
                }},
    MetricEntry{.key = "froude_number",
                .unit = "",
                .absent_when = {open_channel_only, not_reached},
                .definition = "front_velocity_m_s over the square root of g cos(slope) flow depth, "
                              "for an open channel",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  if (!run.deepest) return open_channel_only;
                  if (!run.front.speed || run.deepest->depth <= 0.0) return not_reached;
                  return *run.front.speed /
                         std::sqrt(run.gravity * std::cos(run.slope) * run.deepest->depth);
                }},
    MetricEntry{
        .key = "kinetic_energy_peak_j_per_m",
        .unit = "J/m",
        .least = 0.0,
        .absent_when = {nothing_moved},
        .definition =
            "largest kinetic energy in the window 0.05 m either side of the first foot, or of the "
            "monitored place (Eq. 16), no later than 0.1 s after the flow met the first barrier",
        .gauge = [](Readings run, std::size_t) -> Reading {
          return {of(run.energy, &EnergyPhases::peak), nothing_moved};
        }},
    MetricEntry{.key = "kinetic_energy_peak_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {nothing_moved},
                .definition = "time of that peak, the end of the cumulative phase",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.energy, &EnergyPhases::peak_time), nothing_moved};
                }},
    MetricEntry{.key = "kinetic_energy_minimum_j_per_m",
                .unit = "J/m",
                .least = 0.0,
                .absent_when = {nothing_moved, energy_only_falls},
                .definition = "energy in the window from which it rises again most, the depth of "
                              "the interaction phase",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  if (!run.energy) return nothing_moved;
                  return {of(run.energy->rise, &EnergyPhases::Rise::minimum), energy_only_falls};
                }},
    MetricEntry{
        .key = "kinetic_energy_overflow_peak_j_per_m",
        .unit = "J/m",
        .least = 0.0,
        .absent_when = {nothing_moved, energy_only_falls},
        .definition = "energy to which it rises from there",
        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.energy) return nothing_moved;
          return {of(run.energy->rise, &EnergyPhases::Rise::overflow_peak), energy_only_falls};
        }},
    MetricEntry{.key = "kinetic_energy_plateau_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {nothing_moved, still_moving},
                .definition = "time after which the window's kinetic energy stays below 5 % of its "
                              "largest value",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  if (!run.energy) return nothing_moved;
                  return {run.energy->plateau_time, still_moving};
                }},
};

// Of every barrier.
constexpr std::array each_barrier{
    MetricEntry{
        .key = "barrier_K_retention_efficiency",
        .unit = "",
        .least = 0.0,
        .greatest = 1.0,
        .definition =
            "mass upstream of this barrier's line over the mass released (Eq. 17), at the end",
        .gauge = [](Readings run, std::size_t k) -> Reading { return run.barriers[k].retained; },
        .range = one},
    MetricEntry{
        .key = "barrier_K_arrival_time_s",
        .unit = "s",
        .least = 0.0,
        .absent_when = {never_near},
        .definition = "time at which 0.5 % of the released mass is within 20 mm of its line",
        .gauge = [](Readings run, std::size_t k) -> Reading {
          return {run.barriers[k].arrival, never_near};
        }},
    MetricEntry{
        .key = "barrier_K_peak_force_n_per_m",
        .unit = "N/m",
        .least = 0.0,
        .definition = "largest force on the barrier, running mean over 5 ms",
        .gauge = [](Readings run, std::size_t k) -> Reading { return run.barriers[k].peak.force; }},
    MetricEntry{.key = "barrier_K_peak_force_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {no_force},
                .definition = "time of that force",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  const double time = run.barriers[k].peak.force_time;
                  if (time < 0.0) return no_force;
                  return time;
                }},
    MetricEntry{.key = "barrier_K_peak_moment_nm_per_m",
                .unit = "N m/m",
                .least = 0.0,
                .definition =
                    "largest overturning moment about the foot (positive downstream), running "
                    "mean over 5 ms",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return run.barriers[k].peak.moment;
                }},
    MetricEntry{.key = "barrier_K_run_up_height_m",
                .unit = "m",
                .least = 0.0,
                .absent_when = {never_near},
                .definition = "largest height above the bed of material within 40 mm upstream of "
                              "the line, above which 0.1 % of the released mass lies",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  if (!run.barriers[k].arrival) return never_near;
                  return run.barriers[k].run_up;
                }},
    MetricEntry{.key = "barrier_K_overtopping_volume_m3_per_m",
                .unit = "m3/m",
                .least = 0.0,
                .definition = "volume downstream of its line at the end",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return (1.0 - run.barriers[k].retained) * run.released_volume;
                },
                .range = released_volume},
};

constexpr bool complete(std::span<const MetricEntry> entries) {
  return std::ranges::all_of(entries, [](const MetricEntry& entry) {
    return entry.gauge != nullptr && !entry.key.empty() && !entry.definition.empty();
  });
}
static_assert(complete(with_barrier) && complete(every_run) && complete(each_barrier),
              "every metric needs a key, a definition and a gauge");

}  // namespace

MetricTable metric_table() {
  return {with_barrier, every_run, each_barrier};
}

std::string barrier_key(const MetricEntry& entry, std::size_t barrier) {
  return "barrier_" + std::to_string(barrier + 1) + "_" +
         std::string(entry.key.substr(barrier_placeholder.size()));
}

}  // namespace parapet::solver
