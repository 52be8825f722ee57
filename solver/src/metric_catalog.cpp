#include <array>

#include "parapet/solver/result.hpp"

namespace parapet::solver {
namespace {

struct Entry {
  const char* key;
  const char* definition;
  bool may_be_absent;
};

constexpr std::array channel_entries{
    Entry{"front_velocity_m_s",
          "speed of the flow's front, which has 0.5 % of the released mass ahead, over 0.1 m: "
          "centred "
          "on the monitored place of an open channel, ending 0.15 m upstream of the first barrier",
          true},
    Entry{"arrival_time_s",
          "time at which that front reaches the monitored place, or 0.15 m upstream of the first "
          "barrier",
          true},
    Entry{
        "flow_depth_max_m",
        "open channel: largest mean depth (mass over density and length) in the 40 mm upstream of "
        "the monitored place",
        true},
    Entry{"flow_depth_max_time_s", "time of flow_depth_max_m", true},
    Entry{"froude_number",
          "front_velocity_m_s over the square root of g cos(slope) flow depth, for an open channel",
          true},
    Entry{"kinetic_energy_peak_j_per_m",
          "largest kinetic energy in the window 0.05 m either side of the first foot, or of "
          "the monitored place (Eq. 16), no later than 0.1 s after the flow met the first barrier",
          true},
    Entry{"kinetic_energy_peak_time_s", "time of that peak, the end of the cumulative phase", true},
    Entry{"kinetic_energy_minimum_j_per_m",
          "energy in the window from which it rises again most, the depth of the interaction phase",
          true},
    Entry{"kinetic_energy_overflow_peak_j_per_m", "energy to which it rises from there", true},
    Entry{"kinetic_energy_plateau_time_s",
          "time after which the window's kinetic energy stays below 5 % of its largest value",
          true},
};

constexpr std::array overflow_entries{
    Entry{"launch_length_m",
          "distance along the bed from the first barrier's foot to the place where the coherent "
          "overflow (the first 1 % of the released mass to land) touches down, mass median",
          true},
    Entry{"impact_x_m", "the same place, counted from the reservoir's back wall", true},
    Entry{"impact_time_s", "time at which 0.5 % of the released mass has landed", true},
    Entry{"landing_speed_m_s", "mean speed of that mass when 20 mm above the bed", true},
    Entry{"launch_angle_deg",
          "direction of the momentum of that mass when it passed the first barrier's last edge (a "
          "deflector's tip, or the crest), against the world's horizontal",
          true},
    Entry{"launch_speed_m_s", "speed of that mean momentum", true},
    Entry{
        "ballistic_launch_length_m",
        "hand formula (Ng et al. 2023) for a launch with that speed and angle from the mean place "
        "of the passage, a cross-check of launch_length_m",
        true},
    Entry{
        "dead_zone_length_m",
        "length along the bed, from the first barrier's foot upstream, over which more material is "
        "at rest (slower than 0.1 m/s) than the bed alone can hold, deeper than 1.25 tau_y/(rho g "
        "sin slope) (20 to 100 mm), when the overflow lands (or at the end)",
        false},
    Entry{"dead_zone_ratio", "dead_zone_length_m over the deflector's length (D_F)", true},
    Entry{"overflow_volume_m3_per_m", "volume that has crossed the first barrier's line", false},
    Entry{
        "peak_overflow_discharge_m2_s",
        "largest discharge over that line, mean of 20 ms (or of the series interval, when longer)",
        false},
};

constexpr std::array barrier_entries{
    Entry{"retention_efficiency",
          "mass upstream of this barrier's line over the mass released (Eq. 17), at the end",
          false},
    Entry{"arrival_time_s", "time at which 0.5 % of the released mass is within 20 mm of its line",
          true},
    Entry{"peak_force_n_per_m", "largest force on the barrier, running mean over 5 ms", false},
    Entry{"peak_force_time_s", "time of that force", true},
    Entry{"peak_moment_nm_per_m",
          "largest overturning moment about the foot (positive downstream), running mean over 5 ms",
          false},
    Entry{"run_up_height_m",
          "largest height above the bed of material within 40 mm upstream of the line, above which "
          "0.1 % of the released mass lies",
          true},
    Entry{"overtopping_volume_m3_per_m", "volume downstream of its line at the end", false},
};

}  // namespace

std::vector<MetricInfo> metric_catalog(int n_barriers) {
  std::vector<MetricInfo> catalog;
  const auto add = [&](const std::string& prefix, const Entry& entry) {
    catalog.push_back({prefix + entry.key, entry.definition, entry.may_be_absent});
  };
  if (n_barriers > 0) {
    add("",
        {"retention_efficiency",
         "mass upstream of the first barrier's line over the mass released (Eq. 17), at the end",
         false});
    add("", {"retention_efficiency_total",
             "mass upstream of the last barrier's line over the mass released, at the end", false});
    for (const Entry& entry : overflow_entries) add("", entry);
  }
  for (const Entry& entry : channel_entries) add("", entry);
  for (int k = 1; k <= n_barriers; ++k) {
    for (const Entry& entry : barrier_entries) add("barrier_" + std::to_string(k) + "_", entry);
  }
  return catalog;
}

}  // namespace parapet::solver
