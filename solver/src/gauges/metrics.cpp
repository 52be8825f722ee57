// The metrics at the end of a run, from the series and the gauges. Definitions: metric_catalog.cpp.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "recorder.hpp"

namespace parapet::solver {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// Values by key; what is not set stays absent with its reason.
class Sheet {
 public:
  void set(const std::string& key, double value) { values_[key] = value; }
  void absent(const std::string& key, std::string reason) { reasons_[key] = std::move(reason); }

  std::optional<double> find(const std::string& key) const {
    const auto value = values_.find(key);
    return value != values_.end() ? std::optional(value->second) : std::nullopt;
  }

  std::vector<Metric> in_order(int n_barriers) const {
    std::vector<Metric> metrics;
    for (const MetricInfo& info : metric_catalog(n_barriers)) {
      Metric metric{info.key, std::nullopt, ""};
      if (const auto value = values_.find(info.key); value != values_.end()) {
        metric.value = value->second;
      } else {
        const auto reason = reasons_.find(info.key);
        metric.absent_reason =
            reason != reasons_.end() ? reason->second : "not reached in this run";
      }
      metrics.push_back(std::move(metric));
    }
    return metrics;
  }

 private:
  std::map<std::string, double> values_;
  std::map<std::string, std::string> reasons_;
};

// Time at which a growing series first reaches a level, linear between samples; negative if never.
double passing_time(const std::vector<double>& time, const std::vector<double>& values,
                    double level) {
  for (std::size_t r = 1; r < values.size(); ++r) {
    if (values[r] >= level && values[r - 1] < level) {
      const double share = (level - values[r - 1]) / (values[r] - values[r - 1]);
      return time[r - 1] + share * (time[r] - time[r - 1]);
    }
  }
  return -1.0;
}

// Front speed over 0.1 m: centred on the gauge of an open channel, ending 0.15 m upstream of a
// barrier's foot, where neither the stem nor a deflector is in the way yet.
void front_metrics(Sheet& sheet, const std::vector<double>& time, const std::vector<double>& front,
                   double gauge_x, bool open_channel) {
  constexpr double base = 0.1, clear_of_barrier = 0.15;  // [m]
  const double place = open_channel ? gauge_x : gauge_x - clear_of_barrier;
  const double arrival = passing_time(time, front, place);
  const double from = passing_time(time, front, open_channel ? place - 0.5 * base : place - base);
  const double to = passing_time(time, front, open_channel ? place + 0.5 * base : place);
  if (arrival >= 0.0) sheet.set("arrival_time_s", arrival);
  if (from >= 0.0 && to > from) sheet.set("front_velocity_m_s", base / (to - from));
  for (const char* key : {"arrival_time_s", "front_velocity_m_s"}) {
    sheet.absent(key, "the front was not seen passing there");
  }
}

// The largest rise of a series after `from`: where it starts (the dip) and ends (the next peak).
struct Rise {
  std::size_t dip, peak;
  double height;
};

Rise largest_rise(const std::vector<double>& values, std::size_t from) {
  Rise best{from, from, 0.0};
  std::size_t dip = from;
  for (std::size_t r = from; r < values.size(); ++r) {
    if (values[r] < values[dip]) dip = r;
    if (values[r] - values[dip] > best.height) best = {dip, r, values[r] - values[dip]};
  }
  return best;
}

// The paper's three phases: energy accumulates until the flow meets the barrier, falls in the
// interaction, rises again with the overflow, and ends in a plateau. `met` is the time of the
// meeting, negative in an open channel.
void energy_metrics(Sheet& sheet, const std::vector<double>& time,
                    const std::vector<double>& energy, double met) {
  constexpr double meeting = 0.1;           // [s] the first peak comes no later than this
  constexpr double noticeable_rise = 0.02;  // of the largest energy
  constexpr double plateau_share = 0.05;
  const double largest = *std::max_element(energy.begin(), energy.end());
  if (largest <= 0.0) {
    for (const char* key :
         {"kinetic_energy_peak_j_per_m", "kinetic_energy_peak_time_s",
          "kinetic_energy_minimum_j_per_m", "kinetic_energy_overflow_peak_j_per_m",
          "kinetic_energy_plateau_time_s"}) {
      sheet.absent(key, "nothing moved through the window");
    }
    return;
  }
  std::size_t first = 0;
  for (std::size_t r = 0; r < energy.size() && (met < 0.0 || time[r] <= met + meeting); ++r) {
    if (energy[r] > energy[first]) first = r;
  }
  sheet.set("kinetic_energy_peak_j_per_m", energy[first]);
  sheet.set("kinetic_energy_peak_time_s", time[first]);
  const Rise rise = largest_rise(energy, first);
  if (rise.height > noticeable_rise * largest) {
    sheet.set("kinetic_energy_minimum_j_per_m", energy[rise.dip]);
    sheet.set("kinetic_energy_overflow_peak_j_per_m", energy[rise.peak]);
  } else {
    for (const char* key :
         {"kinetic_energy_minimum_j_per_m", "kinetic_energy_overflow_peak_j_per_m"}) {
      sheet.absent(key, "the energy only falls after its first peak");
    }
  }
  std::size_t plateau = energy.size();
  while (plateau > first && energy[plateau - 1] < plateau_share * largest) --plateau;
  if (plateau == energy.size()) {
    sheet.absent("kinetic_energy_plateau_time_s", "the window was still moving at the end");
  } else {
    sheet.set("kinetic_energy_plateau_time_s", time[plateau]);
  }
}

// Largest rate at which `retained` (a share) falls over at least 20 ms.
double peak_loss_rate(const std::vector<double>& time, const std::vector<double>& retained) {
  constexpr double window = 0.020;  // [s]
  double peak = 0.0;
  std::size_t from = 0;
  for (std::size_t to = 1; to < time.size(); ++to) {
    while (from + 1 < to && time[to] - time[from + 1] >= window - 1e-12) ++from;
    if (time[to] - time[from] < window - 1e-12) continue;
    peak = std::max(peak, (retained[from] - retained[to]) / (time[to] - time[from]));
  }
  return peak;
}

// Ng et al. 2023: launch at angle b above the horizontal with speed v from height H over the bed.
double ballistic_distance(const Scene& scene, const LaunchGauge::Launch& launch) {
  const double a = scene.slope, g = scene.gravity;
  const double vn = launch.speed * std::sin(a + launch.angle);
  const double vs = launch.speed * std::cos(a + launch.angle);
  const double t =
      (vn + std::sqrt(vn * vn + 2.0 * g * launch.height * std::cos(a))) / (g * std::cos(a));
  return vs * t + 0.5 * g * std::sin(a) * t * t;
}

}  // namespace

std::vector<Metric> Recorder::metrics() const {
  Sheet sheet;
  const int n_barriers = static_cast<int>(g_.lines.size());
  const std::vector<double> time = column("time_s");
  front_metrics(sheet, time, column("front_x_m"), g_.gauge_x, n_barriers == 0);
  energy_metrics(sheet, time, column("window_kinetic_energy_j_per_m"),
                 arrival_.empty() ? -1.0 : arrival_.front());
  const std::vector<double> depth = column("flow_depth_m");
  if (n_barriers == 0) {
    const auto deepest = std::max_element(depth.begin(), depth.end());
    sheet.set("flow_depth_max_m", *deepest);
    sheet.set("flow_depth_max_time_s", time[static_cast<std::size_t>(deepest - depth.begin())]);
    const auto speed = sheet.find("front_velocity_m_s");
    if (speed && *deepest > 0.0) {
      sheet.set("froude_number",
                *speed / std::sqrt(scene_.gravity * std::cos(scene_.slope) * *deepest));
    }
    return sheet.in_order(0);
  }
  for (const char* key : {"flow_depth_max_m", "flow_depth_max_time_s", "froude_number"}) {
    sheet.absent(key, "gauged in an open channel only: here the barrier backs the flow up");
  }

  const double released_volume = g_.released_mass / scene_.material.density;
  const std::vector<double> retained = column("barrier_1_retention_efficiency");
  sheet.set("retention_efficiency", retained.back());
  sheet.set(
      "retention_efficiency_total",
      value(time.size() - 1, "barrier_" + std::to_string(n_barriers) + "_retention_efficiency"));
  sheet.set("overflow_volume_m3_per_m", (1.0 - retained.back()) * released_volume);
  sheet.set("peak_overflow_discharge_m2_s", peak_loss_rate(time, retained) * released_volume);

  const auto impact = launch_.impact();
  if (impact) {
    sheet.set("impact_time_s", impact->time);
    sheet.set("impact_x_m", impact->x);
    sheet.set("launch_length_m", impact->x - scene_.barriers.front().foot_x);
    sheet.set("landing_speed_m_s", impact->landing_speed);
  } else {
    for (const char* key :
         {"impact_time_s", "impact_x_m", "launch_length_m", "landing_speed_m_s"}) {
      sheet.absent(key, "less than 0.5 % of the released mass landed beyond the first barrier");
    }
  }
  if (const auto launch = launch_.launch()) {
    sheet.set("launch_angle_deg", launch->angle / degree);
    sheet.set("launch_speed_m_s", launch->speed);
    sheet.set("ballistic_launch_length_m",
              launch->x - scene_.barriers.front().foot_x + ballistic_distance(scene_, *launch));
  } else {
    for (const char* key : {"launch_angle_deg", "launch_speed_m_s", "ballistic_launch_length_m"}) {
      sheet.absent(key, "less than 0.5 % of the released mass landed beyond the first barrier");
    }
  }

  const std::vector<double> dead_zone = column("dead_zone_length_m");
  std::size_t reading = time.size() - 1;
  if (impact) {
    while (reading > 0 && time[reading] > impact->time) --reading;
  }
  sheet.set("dead_zone_length_m", dead_zone[reading]);
  if (const auto& deflector = scene_.barriers.front().deflector) {
    sheet.set("dead_zone_ratio", dead_zone[reading] / deflector->length);
  } else {
    sheet.absent("dead_zone_ratio", "the first barrier has no deflector");
  }

  for (int k = 1; k <= n_barriers; ++k) {
    const std::string b = "barrier_" + std::to_string(k) + "_";
    const auto index = static_cast<std::size_t>(k - 1);
    const PeakLoad& peak = loads_.peaks()[index];
    const std::vector<double> run_up = column(b + "run_up_height_m");
    const double held = value(time.size() - 1, b + "retention_efficiency");
    sheet.set(b + "retention_efficiency", held);
    sheet.set(b + "overtopping_volume_m3_per_m", (1.0 - held) * released_volume);
    sheet.set(b + "peak_force_n_per_m", peak.force);
    sheet.set(b + "peak_moment_nm_per_m", peak.moment);
    if (peak.force_time >= 0.0) {
      sheet.set(b + "peak_force_time_s", peak.force_time);
    } else {
      sheet.absent(b + "peak_force_time_s", "nothing reached the barrier");
    }
    if (arrival_[index] >= 0.0) {
      sheet.set(b + "arrival_time_s", arrival_[index]);
      sheet.set(b + "run_up_height_m", *std::max_element(run_up.begin(), run_up.end()));
    } else {
      sheet.absent(b + "arrival_time_s", "too little reached the barrier");
      sheet.absent(b + "run_up_height_m", "too little reached the barrier");
    }
  }
  return sheet.in_order(n_barriers);
}

}  // namespace parapet::solver
