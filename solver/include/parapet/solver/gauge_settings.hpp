/// What the gauges look at: every window, threshold and duration as a ratio to one unit of the
/// event, so that a flume and a valley are measured alike.
#pragma once

#include <string>
#include <vector>

#include "parapet/solver/scene.hpp"

namespace parapet::solver {

/// The units of an event, made of the depth that is released and of gravity alone: no barrier
/// changes them.
struct EventUnits {
  double length;  ///< H0 [m]
  double time;    ///< sqrt(H0/g) [s]; 0.143 s in the flume of the default scene
  double speed;   ///< sqrt(g H0) [m/s]; 1.40 m/s in the flume
};

/// Ratios to H0 (lengths), sqrt(H0/g) (times) and sqrt(g H0) (speeds), and shares of the released
/// mass. Comments give the value in the flume of the default scene, H0 = 0.2 m.
struct GaugeSettings {
  /// H0 [m]; 0: the height of the released block. Where a search changes the block, give it: the
  /// gauges of all designs must look at the same windows.
  double event_length = 0.0;

  double front_mass_share = 0.005;      ///< ahead of what is called the front
  double front_base_ratio = 0.5;        ///< over which its speed is taken; 0.1 m
  double front_clearance_ratio = 0.75;  ///< of that place from a barrier's foot; 0.15 m
  double depth_window_ratio = 0.2;      ///< upstream of the gauge of an open channel; 40 mm
  double energy_window_ratio = 0.25;    ///< either side of the first foot; 50 mm, as in the paper
  double first_peak_time_ratio = 0.7;   ///< its first peak comes no later after arrival; 0.1 s

  double arrival_mass_share = 0.005;  ///< in the window at a barrier when the flow arrives
  double arrival_window_ratio = 0.1;  ///< 20 mm
  double run_up_mass_share = 0.001;   ///< above the run-up height
  double run_up_window_ratio = 0.2;   ///< 40 mm

  double impact_mass_share = 0.005;    ///< has landed at the time of the impact
  double launch_mass_share = 0.010;    ///< first to land: the coherent overflow
  double landing_height_ratio = 0.05;  ///< above the bed, of a particle that has landed; 10 mm
  double approach_height_ratio = 0.1;  ///< above the bed, where its speed is read; 20 mm
  double discharge_time_ratio = 0.14;  ///< mean of the peak discharge; 20 ms

  double rest_speed_ratio = 0.0714;          ///< slower is at rest; 0.1 m/s
  double dead_zone_window_ratio = 0.1;       ///< a column of it along the bed; 20 mm
  double dead_zone_depth_factor = 1.25;      ///< of the layer that rests on the bed alone
  double dead_zone_least_depth_ratio = 0.1;  ///< asked for at least; 20 mm
  double dead_zone_most_depth_ratio = 0.5;   ///< asked for at most; 0.1 m

  double design_load_time_ratio = 0.7;  ///< running mean of the design load; 0.1 s
  double short_load_time_ratio = 0.35;  ///< and of the load over the short window; 50 ms
  double slam_time_ratio = 0.035;       ///< and of the slam, which does not converge; 5 ms
  double impulse_time_ratio = 3.5;      ///< of the impulse, from the arrival on; 0.5 s

  // Of the first barrier's ramp at RunOptions::reading_time, over the height of its stem: from
  // where to where upstream of the last edge the surface is looked at, in columns of which width.
  double ramp_near_ratio = 0.5;    ///< 50 mm at a stem of 100 mm
  double ramp_far_ratio = 2.0;     ///< 200 mm
  double ramp_column_ratio = 0.2;  ///< 20 mm
  friend bool operator==(const GaugeSettings&, const GaugeSettings&) = default;
};

/// The units that a scene's gauges count in.
EventUnits event_units(const Scene& scene, const GaugeSettings& settings);

/// Everything wrong with the settings, one sentence each; empty when they are sound.
std::vector<std::string> gauge_errors(const GaugeSettings& settings);

/// A window that fewer particles span along its length measures single particles: what is read
/// there is absent.
constexpr double fewest_across_window = 4.0;

/// Likewise for a share of the released mass that holds fewer particles.
constexpr double fewest_in_share = 2.0;

}  // namespace parapet::solver
