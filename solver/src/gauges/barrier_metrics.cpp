// Metrics of every barrier.
#include <array>
#include <cmath>

#include "metric_entries.hpp"

namespace parapet::solver {
namespace {

using namespace metric_entries;

// Not gauged while a run goes on: how the pile creeps does not prolong it.
HeldDebris held(Readings run, std::size_t barrier) {
  return run.barriers[barrier].held.value_or(HeldDebris{});
}

// rho v^2 h and rho g h^2/2 of the undisturbed flow [N/m]: the hand formulas with a factor of 1.
double hydrodynamic_load(Readings run, const Approach& flow) {
  return run.density * *flow.front_velocity * *flow.front_velocity * *flow.depth;
}

double hydrostatic_load(Readings run, const Approach& flow) {
  return 0.5 * run.density * run.gravity * *flow.depth * *flow.depth;
}

// Of every barrier.
constexpr std::array barrier_entries{
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
    MetricEntry{.key = "barrier_K_hydrodynamic_coefficient",
                .unit = "",
                .least = 0.0,
                .absent_when = {&no_approach, &approach_not_seen},
                .definition =
                    "alpha of the hand formula alpha rho v^2 h: design force over rho v^2 h, with "
                    "velocity v of the front (over front_base, 0.5 H0) and depth h (largest mean "
                    "over depth_window, 0.2 H0) of the undisturbed flow at the barrier's foot",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  const BarrierReadings& barrier = run.barriers[k];
                  if (!barrier.approach) return no_approach;
                  const Approach& flow = *barrier.approach;
                  if (!flow.front_velocity || !flow.depth) return approach_not_seen;
                  return barrier.loads.peak[design_window].force / hydrodynamic_load(run, flow);
                },
                .coarsest = [](Settings s) { return s.depth_window_ratio / fewest_across_window; },
                .mass_share = [](Settings s) { return s.front_mass_share; }},
    MetricEntry{.key = "barrier_K_hydrostatic_coefficient",
                .unit = "",
                .least = 0.0,
                .absent_when = {&no_approach, &approach_not_seen},
                .definition = "k of the hand formula k rho g h^2/2: design force over rho g h^2/2, "
                              "with the same depth h",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  const BarrierReadings& barrier = run.barriers[k];
                  if (!barrier.approach) return no_approach;
                  const Approach& flow = *barrier.approach;
                  if (!flow.depth) return approach_not_seen;
                  return barrier.loads.peak[design_window].force / hydrostatic_load(run, flow);
                },
                .coarsest = [](Settings s) { return s.depth_window_ratio / fewest_across_window; }},
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
    MetricEntry{
        .key = "barrier_K_dead_zone_length_m",
        .unit = "m",
        .least = 0.0,
        .definition =
            "like dead_zone_length_m, but upstream of every barrier, as far as the one before "
            "it, and at the end",
        .gauge = [](Readings run, std::size_t k) -> Reading {
          return held(run, k).dead_zone.length;
        },
        .coarsest = [](Settings s) { return s.dead_zone_window_ratio / fewest_across_window; }},
    MetricEntry{
        .key = "barrier_K_dead_zone_area_m2",
        .unit = "m2",
        .least = 0.0,
        .definition = "area of what is at rest over that length then",
        .gauge = [](Readings run, std::size_t k) -> Reading { return held(run, k).dead_zone.area; },
        .coarsest = [](Settings s) { return s.dead_zone_window_ratio / fewest_across_window; }},
    MetricEntry{.key = "barrier_K_ramp_angle_deg",
                .unit = "deg",
                .least = -90.0,
                .greatest = 90.0,
                .absent_when = {&no_ramp_held, &absence::too_coarse},
                .definition = "like ramp_angle_deg, but upstream of every barrier, and at the end",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  const Ramp ramp = held(run, k).ramp;
                  if (ramp.too_coarse) return absence::too_coarse;
                  if (!ramp.angle) return no_ramp_held;
                  return *ramp.angle / degree;
                }},
    MetricEntry{
        .key = "barrier_K_dead_zone_onset_time_s",
        .unit = "s",
        .least = 0.0,
        .absent_when = {&no_dead_zone},
        .definition = "time from which on there has been a dead zone as long as one column, "
                      "dead_zone_window (0.1 H0), upstream of it",
        .gauge = [](Readings run, std::size_t k) -> Reading {
          return {run.barriers[k].events.dead_zone_onset, no_dead_zone};
        },
        .coarsest = [](Settings s) { return s.dead_zone_window_ratio / fewest_across_window; }},
    MetricEntry{.key = "barrier_K_backflow_share",
                .unit = "",
                .least = 0.0,
                .greatest = 1.0,
                .definition =
                    "largest share of the released mass that flows upstream at once, faster than "
                    "rest_speed (0.0714 sqrt(g H0)), between the barrier before (or the back wall) "
                    "and this one, since the flow met this one",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return run.barriers[k].events.backflow.share;
                }},
    MetricEntry{.key = "barrier_K_backflow_speed_m_s",
                .unit = "m/s",
                .least = 0.0,
                .absent_when = {&no_backflow},
                .definition =
                    "largest speed upstream that impact_mass_share (0.5 %) of the released mass "
                    "exceeds there at once",
                .gauge = [](Readings run, std::size_t k) -> Reading {
                  return {run.barriers[k].events.backflow.speed, no_backflow};
                },
                .mass_share = [](Settings s) { return s.impact_mass_share; }},
};

static_assert(complete(barrier_entries), "every metric needs a key, a definition and a gauge");

}  // namespace

std::span<const MetricEntry> barrier_metrics() {
  return barrier_entries;
}

}  // namespace parapet::solver
