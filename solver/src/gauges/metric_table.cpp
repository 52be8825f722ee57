#include "metric_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace parapet::solver {
namespace {

using Readings = const RunReadings&;
using Settings = const GaugeSettings&;

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

constexpr Absent front_not_seen{.text = "the front was not seen passing there", .may_come = true};
constexpr Absent open_channel_only{
    .text = "gauged in an open channel only: here the barrier backs the flow up"};
constexpr Absent not_reached{.text = "not reached in this run", .may_come = true};
constexpr Absent nothing_moved{.text = "nothing moved through the window", .may_come = true};
constexpr Absent energy_only_falls{.text = "the energy only falls after its first peak",
                                   .may_come = true};
constexpr Absent still_moving{.text = "the window was still moving at the end", .may_come = true};
constexpr Absent nothing_landed{
    .text = "less than impact_mass_share of the released mass landed beyond the first barrier",
    .may_come = true};
constexpr Absent no_deflector{.text = "the first barrier has no deflector"};
constexpr Absent did_not_pass_edge{
    .text = "what landed first had not passed over the first barrier's last edge"};
constexpr Absent no_force{.text = "no force acted on the barrier", .may_come = true};
constexpr Absent never_near{.text =
                                "arrival_mass_share of the released mass was never within "
                                "arrival_window of the line at once",
                            .may_come = true};

constexpr Absent no_push{.text = "the design force does not push the stem downstream",
                         .may_come = true};
constexpr Absent not_at_rest{
    .text = "read at rest only: the run was not until_rest, or it ended before",
    .kind = Absence::run_too_short};
constexpr Absent no_reading_time{.text = "no run.reading_time_s was given"};
constexpr Absent nothing_beyond{.text = "nothing was beyond the first barrier at run.reading_time"};
constexpr Absent no_ramp{.text =
                             "at run.reading_time the debris did not reach over the whole ramp"};

constexpr Absent ended_before_reading{.text = "the run ended before run.reading_time",
                                      .kind = Absence::run_too_short};
constexpr Absent impulse_cut_off{.text = "the run ended before impulse_time was over",
                                 .kind = Absence::run_too_short};

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

const Absent& why_no_launch(Readings run) {
  return run.impact ? did_not_pass_edge : nothing_landed;
}

using Tongue = InstantReadings::Tongue;

Reading tongue(Readings run, double (*value)(const Tongue&)) {
  if (!run.instant_wanted) return no_reading_time;
  if (!run.instant) return ended_before_reading;
  if (!run.instant->tongue) return nothing_beyond;
  return value(*run.instant->tongue);
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
    MetricEntry{.key = "launch_length_m",
                .unit = "m",
                .least = 0.0,
                .absent_when = {&nothing_landed},
                .definition =
                    "distance along the bed from the first barrier's foot to the place where the "
                    "coherent overflow (the first launch_mass_share, 1 %, of the released mass "
                    "to land) touches down, mass median; what has landed has come closer than "
                    "landing_height (0.05 H0) to the bed below it; 0 where a leaning stem lets it "
                    "land upstream of the foot",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  if (!run.impact) return nothing_landed;
                  return std::max(0.0, run.impact->x - run.first_foot_x);
                },
                .coarsest = [](Settings s) { return 1.5 * s.landing_height_ratio; },
                .coarse_reason = &absence::too_large,
                .mass_share = [](Settings s) { return s.launch_mass_share; }},
    MetricEntry{.key = "impact_x_m",
                .unit = "m",
                .least = 0.0,
                .absent_when = {&nothing_landed},
                .definition = "the same place, counted from the reservoir's back wall",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.impact, &LaunchGauge::Impact::x), nothing_landed};
                },
                .coarsest = [](Settings s) { return 1.5 * s.landing_height_ratio; },
                .coarse_reason = &absence::too_large,
                .mass_share = [](Settings s) { return s.launch_mass_share; }},
    MetricEntry{
        .key = "impact_time_s",
        .unit = "s",
        .least = 0.0,
        .absent_when = {&nothing_landed},
        .definition = "time at which impact_mass_share (0.5 %) of the released mass has landed",

        .gauge = [](Readings run, std::size_t) -> Reading {
          return {of(run.impact, &LaunchGauge::Impact::time), nothing_landed};
        },
        .coarsest = [](Settings s) { return 1.5 * s.landing_height_ratio; },
        .coarse_reason = &absence::too_large,
        .mass_share = [](Settings s) { return s.impact_mass_share; }},
    MetricEntry{.key = "landing_speed_m_s",
                .unit = "m/s",
                .least = 0.0,
                .absent_when = {&nothing_landed},
                .definition =
                    "mean speed of the coherent overflow at approach_height (0.1 H0) above the bed",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.impact, &LaunchGauge::Impact::landing_speed), nothing_landed};
                },
                .coarsest = [](Settings s) { return 1.5 * s.landing_height_ratio; },
                .coarse_reason = &absence::too_large,
                .mass_share = [](Settings s) { return s.launch_mass_share; }},
    MetricEntry{
        .key = "launch_angle_deg",
        .unit = "deg",
        .absent_when = {&nothing_landed, &did_not_pass_edge},
        .definition =
            "direction of the momentum of that mass when it passed the first barrier's last edge "
            "(a deflector's tip, or the crest), against the world's horizontal",

        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.launch) return why_no_launch(run);
          return run.launch->angle / degree;
        },
        .coarsest = [](Settings s) { return 1.5 * s.landing_height_ratio; },
        .coarse_reason = &absence::too_large,
        .mass_share = [](Settings s) { return s.launch_mass_share; }},
    MetricEntry{.key = "launch_speed_m_s",
                .unit = "m/s",
                .least = 0.0,
                .absent_when = {&nothing_landed, &did_not_pass_edge},
                .definition = "speed of that mean momentum",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.launch, &LaunchGauge::Launch::speed), why_no_launch(run)};
                },
                .coarsest = [](Settings s) { return 1.5 * s.landing_height_ratio; },
                .coarse_reason = &absence::too_large,
                .mass_share = [](Settings s) { return s.launch_mass_share; }},
    MetricEntry{
        .key = "ballistic_launch_length_m",
        .unit = "m",
        .absent_when = {&nothing_landed, &did_not_pass_edge},
        .definition =
            "hand formula (Ng et al. 2023) for a launch with that speed and angle from the mean "
            "place of the passage, a cross-check of launch_length_m",

        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.launch) return why_no_launch(run);
          return run.launch->x - run.first_foot_x + ballistic_distance(run, *run.launch);
        },
        .coarsest = [](Settings s) { return 1.5 * s.landing_height_ratio; },
        .coarse_reason = &absence::too_large,
        .mass_share = [](Settings s) { return s.launch_mass_share; }},
    MetricEntry{.key = "launch_tip_x_m",
                .unit = "m",
                .absent_when = {&no_reading_time, &nothing_beyond, &ended_before_reading},
                .definition =
                    "largest x, from the reservoir's back wall, of the fluid connected with the "
                    "main body beyond the first barrier's line (through particles within the "
                    "kernel's reach of each other) at run.reading_time",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return tongue(run, [](const Tongue& t) { return t.tip_x; });
                }},
    MetricEntry{.key = "launch_tip_landed",
                .unit = "",
                .least = 0.0,
                .greatest = 1.0,
                .absent_when = {&no_reading_time, &nothing_beyond, &ended_before_reading},
                .definition = "1 where that body, within approach_height (0.1 H0) of its tip, has "
                              "landed by then, 0 where it is in the air",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return tongue(run, [](const Tongue& t) { return t.landed ? 1.0 : 0.0; });
                }},
    MetricEntry{
        .key = "launch_farthest_x_m",
        .unit = "m",
        .absent_when = {&no_reading_time, &nothing_beyond, &ended_before_reading},
        .definition =
            "largest x of any particle beyond the line at run.reading_time, be it a single droplet",
        .gauge = [](Readings run, std::size_t) -> Reading {
          return tongue(run, [](const Tongue& t) { return t.farthest_x; });
        }},
    MetricEntry{
        .key = "ramp_angle_deg",
        .unit = "deg",
        .least = -90.0,
        .greatest = 90.0,
        .absent_when = {&no_reading_time, &no_ramp, &ended_before_reading, &absence::too_coarse},
        .definition = "slope of the free surface upstream of the first barrier against the bed at "
                      "run.reading_time: least squares line through the highest particles of the "
                      "main body in columns of ramp_column (0.2 of the stem's height), from "
                      "ramp_near (0.5) to ramp_far (2) stem heights upstream of the last edge",
        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.instant_wanted) return no_reading_time;
          if (!run.instant) return ended_before_reading;
          if (run.instant->ramp_too_coarse) return absence::too_coarse;
          if (!run.instant->ramp_angle) return no_ramp;
          return *run.instant->ramp_angle / degree;
        }},
    MetricEntry{
        .key = "dead_zone_length_m",
        .unit = "m",
        .least = 0.0,
        .definition = "length along the bed, from the first barrier's foot upstream, over which "
                      "more material is at rest (slower than rest_speed, 0.0714 sqrt(g H0)) than "
                      "the bed alone can hold, deeper than dead_zone_depth_factor (1.25) "
                      "tau_y/(rho g sin slope of the bed there) (0.1 to 0.5 H0), in columns of "
                      "dead_zone_window (0.1 H0), when the overflow lands (or at the end)",

        .gauge = [](Readings run, std::size_t) -> Reading { return run.dead_zone_length; },
        .coarsest = [](Settings s) { return s.dead_zone_window_ratio / fewest_across_window; },
        .range = way_to_barrier},
    MetricEntry{
        .key = "dead_zone_ratio",
        .unit = "",
        .least = 0.0,
        .absent_when = {&no_deflector},
        .definition = "dead_zone_length_m over the deflector's length (D_F)",

        .gauge = [](Readings run, std::size_t) -> Reading {
          if (!run.deflector_length) return no_deflector;
          return run.dead_zone_length / *run.deflector_length;
        },
        .coarsest = [](Settings s) { return s.dead_zone_window_ratio / fewest_across_window; },
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
                .definition = "largest discharge over that line, mean of discharge_time (0.14 "
                              "sqrt(H0/g)), or of the series interval, when longer",

                .gauge = [](Readings run, std::size_t) -> Reading {
                  return run.peak_loss_rate * run.released_volume;
                }},
};

// Of the flow at the first barrier's foot, or at the monitored place of an open channel.
constexpr std::array every_run{
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
        .absent_when = {&never_near},
        .definition = "time at which arrival_mass_share (0.5 %) of the released mass is within "
                      "arrival_window (0.1 H0) upstream of its line",

        .gauge = [](Readings run, std::size_t k) -> Reading {
          return {run.barriers[k].arrival, never_near};
        },
        .coarsest = [](Settings s) { return s.arrival_window_ratio / fewest_across_window; },
        .mass_share = [](Settings s) { return s.arrival_mass_share; }},
    MetricEntry{.key = "barrier_K_design_force_n_per_m",
                .unit = "N/m",
                .least = 0.0,
                .definition = "largest running mean of the force on the barrier over "
                              "design_load_time (0.7 sqrt(H0/g)), the load to design with",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return run.barriers[k].loads.peak[design_window].force;
                }},
    MetricEntry{.key = "barrier_K_design_force_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {&no_force},
                .definition = "end of that window",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  const double time = run.barriers[k].loads.peak[design_window].force_time;
                  if (time < 0.0) return no_force;
                  return time;
                }},
    MetricEntry{.key = "barrier_K_design_moment_nm_per_m",
                .unit = "N m/m",
                .least = 0.0,
                .definition = "largest running mean of the overturning moment about the foot "
                              "(positive downstream) over design_load_time (0.7 sqrt(H0/g))",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return run.barriers[k].loads.peak[design_window].moment;
                }},
    MetricEntry{.key = "barrier_K_design_load_height_m",
                .unit = "m",
                .absent_when = {&no_push},
                .definition = "distance from the foot, along the stem, at which the design force "
                              "acts: its moment over its part normal to the stem",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return {run.barriers[k].load_height, no_push};
                }},
    MetricEntry{
        .key = "barrier_K_stem_design_force_n_per_m",
        .unit = "N/m",
        .least = 0.0,
        .definition = "largest running mean over design_load_time (0.7 sqrt(H0/g)) of the force on "
                      "the stem alone",
        .gauge = [](Readings run, std::size_t k) -> Reading { return run.barriers[k].loads.stem; }},
    MetricEntry{.key = "barrier_K_deflector_design_force_n_per_m",
                .unit = "N/m",
                .least = 0.0,
                .definition = "the same of the force on the deflector alone; 0 without one",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return run.barriers[k].loads.deflector;
                }},
    MetricEntry{
        .key = "barrier_K_short_window_force_n_per_m",
        .unit = "N/m",
        .least = 0.0,
        .definition = "largest running mean of the force over short_load_time (0.35 sqrt(H0/g))",
        .gauge = [](Readings run, std::size_t k) -> Reading {
          return run.barriers[k].loads.peak[short_window].force;
        }},
    MetricEntry{
        .key = "barrier_K_short_window_moment_nm_per_m",
        .unit = "N m/m",
        .least = 0.0,
        .definition =
            "largest running mean of the overturning moment over short_load_time (0.35 sqrt(H0/g))",
        .gauge = [](Readings run, std::size_t k) -> Reading {
          return run.barriers[k].loads.peak[short_window].moment;
        }},
    MetricEntry{.key = "barrier_K_impulse_n_s_per_m",
                .unit = "N s/m",
                .least = 0.0,
                .absent_when = {&never_near, &impulse_cut_off},
                .definition = "magnitude of the impulse on the barrier over impulse_time (3.5 "
                              "sqrt(H0/g)) from its arrival on",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  if (!run.barriers[k].arrival) return never_near;
                  return {run.barriers[k].impulse, impulse_cut_off};
                }},
    MetricEntry{.key = "barrier_K_slam_force_n_per_m",
                .unit = "N/m",
                .least = 0.0,
                .definition =
                    "largest running mean of the force over slam_time (0.035 sqrt(H0/g)); it "
                    "does not converge with the particle spacing: no load to design with",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return run.barriers[k].loads.peak[slam_window].force;
                }},
    MetricEntry{.key = "barrier_K_slam_force_time_s",
                .unit = "s",
                .least = 0.0,
                .absent_when = {&no_force},
                .definition = "end of that window",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  const double time = run.barriers[k].loads.peak[slam_window].force_time;
                  if (time < 0.0) return no_force;
                  return time;
                }},
    MetricEntry{.key = "barrier_K_slam_moment_nm_per_m",
                .unit = "N m/m",
                .least = 0.0,
                .definition = "largest running mean of the overturning moment over slam_time "
                              "(0.035 sqrt(H0/g)); unconverged like the force",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return run.barriers[k].loads.peak[slam_window].moment;
                }},
    MetricEntry{.key = "barrier_K_static_force_n_per_m",
                .unit = "N/m",
                .least = 0.0,
                .absent_when = {&not_at_rest},
                .definition = "force on the barrier once all is at rest (run.until_rest), mean "
                              "over the window of the settle rule",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  if (!run.barriers[k].at_rest) return not_at_rest;
                  return norm(run.barriers[k].at_rest->force);
                }},
    MetricEntry{.key = "barrier_K_static_moment_nm_per_m",
                .unit = "N m/m",
                .absent_when = {&not_at_rest},
                .definition = "overturning moment then",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  if (!run.barriers[k].at_rest) return not_at_rest;
                  return run.barriers[k].at_rest->moment;
                }},
    MetricEntry{
        .key = "barrier_K_run_up_height_m",
        .unit = "m",
        .least = 0.0,
        .absent_when = {&never_near},
        .definition =
            "largest height above the bed of material within run_up_window (0.2 H0) upstream of "
            "the line, above which run_up_mass_share (0.1 %) of the released mass lies",

        .gauge = [](Readings run, std::size_t k) -> Reading {
          if (!run.barriers[k].arrival) return never_near;
          return run.barriers[k].run_up;
        },
        .coarsest = [](Settings s) { return s.run_up_window_ratio / fewest_across_window; },
        .mass_share = [](Settings s) { return s.run_up_mass_share; }},
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

std::vector<const Absent*> absent_when(const MetricEntry& entry) {
  std::vector<const Absent*> reasons;
  bool may_come = false;
  for (const Absent* reason : entry.absent_when) {
    if (reason == nullptr) continue;
    reasons.push_back(reason);
    may_come = may_come || reason->may_come;
  }
  if (entry.coarsest) reasons.push_back(entry.coarse_reason);
  if (entry.mass_share) reasons.push_back(&absence::too_few);
  if (may_come) reasons.push_back(&absence::run_too_short);
  return reasons;
}

MetricTable metric_table() {
  return {with_barrier, every_run, each_barrier};
}

std::string barrier_key(const MetricEntry& entry, std::size_t barrier) {
  return "barrier_" + std::to_string(barrier + 1) + "_" +
         std::string(entry.key.substr(barrier_placeholder.size()));
}

}  // namespace parapet::solver
