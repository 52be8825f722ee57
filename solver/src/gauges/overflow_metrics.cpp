// Metrics of the overflow over the first barrier.
#include <algorithm>
#include <array>
#include <cmath>

#include "metric_entries.hpp"

namespace parapet::solver {
namespace {

using namespace metric_entries;

double way_to_barrier(Readings run) {
  return run.first_foot_x;
}
double deflectors_to_barrier(Readings run) {
  return run.first_foot_x / run.deflector_length.value_or(run.first_foot_x);
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
constexpr std::array overflow_entries{
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
          const Ramp& ramp = run.instant->ramp;
          if (ramp.too_coarse) return absence::too_coarse;
          if (!ramp.angle) return no_ramp;
          return *ramp.angle / degree;
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
    MetricEntry{.key = "overflow_speed_m_s",
                .unit = "m/s",
                .least = 0.0,
                .absent_when = {&little_passed},
                .definition =
                    "speed, of the mean momentum, of what passes over the first barrier's "
                    "last edge while that discharge, mean of discharge_time (0.14 "
                    "sqrt(H0/g)), is largest",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.sheet, &LaunchGauge::Sheet::speed), little_passed};
                },
                .mass_share = [](Settings s) { return s.impact_mass_share; }},
    MetricEntry{.key = "overflow_thickness_m",
                .unit = "m",
                .least = 0.0,
                .absent_when = {&little_passed},
                .definition = "thickness of the overflow there: that discharge over that speed",
                .gauge = [](Readings run, std::size_t) -> Reading {
                  return {of(run.sheet, &LaunchGauge::Sheet::thickness), little_passed};
                },
                .mass_share = [](Settings s) { return s.impact_mass_share; }},
};

static_assert(complete(overflow_entries), "every metric needs a key, a definition and a gauge");

}  // namespace

std::span<const MetricEntry> overflow_metrics() {
  return overflow_entries;
}

}  // namespace parapet::solver
