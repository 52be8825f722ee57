#include "parapet/solver/gauge_settings.hpp"

#include <cmath>

namespace parapet::solver {

EventUnits event_units(const Scene& scene, const GaugeSettings& settings) {
  const double length =
      settings.event_length > 0.0 ? settings.event_length : scene.reservoir_height;
  return {length, std::sqrt(length / scene.gravity), std::sqrt(length * scene.gravity)};
}

std::vector<std::string> gauge_errors(const GaugeSettings& s) {
  std::vector<std::string> errors;
  const auto require = [&](bool sound, const char* name, double value, const char* allowed) {
    if (sound && std::isfinite(value)) return;
    errors.push_back("the gauges' " + std::string(name) + " is " + std::to_string(value) +
                     "; allowed: " + allowed);
  };
  require(s.event_length >= 0.0, "event length", s.event_length,
          "0 (the released block's) or more");
  const auto share = [&](const char* name, double value) {
    require(value > 0.0 && value < 1.0, name, value, "between 0 and 1");
  };
  share("front mass share", s.front_mass_share);
  share("arrival mass share", s.arrival_mass_share);
  share("run-up mass share", s.run_up_mass_share);
  share("impact mass share", s.impact_mass_share);
  share("launch mass share", s.launch_mass_share);
  require(s.launch_mass_share >= s.impact_mass_share, "launch mass share", s.launch_mass_share,
          "at least the impact mass share");
  const auto positive = [&](const char* name, double value) {
    require(value > 0.0, name, value, "more than 0");
  };
  positive("front base", s.front_base_ratio);
  require(s.front_clearance_ratio >= 0.0, "front clearance", s.front_clearance_ratio, "0 or more");
  positive("depth window", s.depth_window_ratio);
  positive("energy window", s.energy_window_ratio);
  positive("first peak time", s.first_peak_time_ratio);
  positive("arrival window", s.arrival_window_ratio);
  positive("run-up window", s.run_up_window_ratio);
  positive("landing height", s.landing_height_ratio);
  require(s.approach_height_ratio >= s.landing_height_ratio, "approach height",
          s.approach_height_ratio, "at least the landing height");
  positive("discharge time", s.discharge_time_ratio);
  positive("rest speed", s.rest_speed_ratio);
  positive("dead zone window", s.dead_zone_window_ratio);
  positive("dead zone depth factor", s.dead_zone_depth_factor);
  positive("dead zone least depth", s.dead_zone_least_depth_ratio);
  require(s.dead_zone_most_depth_ratio >= s.dead_zone_least_depth_ratio, "dead zone most depth",
          s.dead_zone_most_depth_ratio, "at least the least depth");
  positive("slam time", s.slam_time_ratio);
  require(s.short_load_time_ratio >= s.slam_time_ratio, "short load time", s.short_load_time_ratio,
          "at least the slam time");
  require(s.design_load_time_ratio >= s.short_load_time_ratio, "design load time",
          s.design_load_time_ratio, "at least the short load time");
  require(s.impulse_time_ratio >= s.design_load_time_ratio, "impulse time", s.impulse_time_ratio,
          "at least the design load time");
  require(s.ramp_near_ratio >= 0.0, "ramp near", s.ramp_near_ratio, "0 or more");
  require(s.ramp_far_ratio > s.ramp_near_ratio, "ramp far", s.ramp_far_ratio,
          "more than the ramp near");
  positive("ramp column", s.ramp_column_ratio);
  return errors;
}

}  // namespace parapet::solver
