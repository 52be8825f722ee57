// The metrics at the end of a run: its readings, and the table's gauges applied to them.
#include <algorithm>
#include <cmath>

#include "metric_table.hpp"
#include "recorder.hpp"
#include "run_readings.hpp"

namespace parapet::solver {

std::vector<Metric> read_metrics(const RunReadings& run) {
  std::vector<Metric> metrics;
  for_each_metric(
      run.barriers.size(), [&](std::string key, const MetricEntry& entry, std::size_t k) {
        const Reading reading = entry.gauge(run, k);
        metrics.push_back({std::move(key), reading.value, std::string(reading.absent_reason)});
      });
  return metrics;
}

bool metric_moved(const RunReadings& before, const RunReadings& now, double share) {
  bool moved = false;
  for_each_metric(now.barriers.size(),
                  [&](const std::string&, const MetricEntry& entry, std::size_t k) {
                    const Reading a = entry.gauge(before, k), b = entry.gauge(now, k);
                    if (a.value && b.value && entry.range != nullptr) {
                      moved = moved || std::abs(*b.value - *a.value) > share * entry.range(now);
                    } else {
                      moved = moved || a.value != b.value;
                    }
                  });
  return moved;
}

RunReadings Recorder::readings() const {
  const std::size_t n_barriers = g_.lines.size();
  const std::vector<double> time = column("time_s");
  const std::size_t last = time.size() - 1;
  RunReadings run;
  run.gravity = scene_.gravity;
  run.slope = scene_.slope;
  run.released_volume = g_.released_mass / scene_.material.density;
  run.front = front_passage(time, column("front_x_m"), g_.gauge_x, n_barriers == 0);
  run.energy = energy_phases(time, column("window_kinetic_energy_j_per_m"),
                             arrival_.empty() ? -1.0 : arrival_.front());
  if (n_barriers == 0) {
    const std::vector<double> depth = column("flow_depth_m");
    const auto deepest = std::max_element(depth.begin(), depth.end());
    run.deepest = {*deepest, time[static_cast<std::size_t>(deepest - depth.begin())]};
    return run;
  }

  const Barrier& first = scene_.barriers.front();
  run.first_foot_x = first.foot_x;
  if (first.deflector) run.deflector_length = first.deflector->length;
  run.peak_loss_rate = peak_loss_rate(time, column("barrier_1_retention_efficiency"));
  run.impact = launch_.impact();
  run.launch = launch_.launch();
  std::size_t landing = last;
  if (run.impact) {
    while (landing > 0 && time[landing] > run.impact->time) --landing;
  }
  run.dead_zone_length = value(landing, "dead_zone_length_m");
  for (std::size_t k = 0; k < n_barriers; ++k) {
    const std::string b = "barrier_" + std::to_string(k + 1) + "_";
    const std::vector<double> run_up = column(b + "run_up_height_m");
    BarrierReadings& barrier = run.barriers.emplace_back();
    barrier.retained = value(last, b + "retention_efficiency");
    barrier.run_up = *std::max_element(run_up.begin(), run_up.end());
    if (arrival_[k] >= 0.0) barrier.arrival = arrival_[k];
    barrier.peak = loads_.peaks()[k];
  }
  return run;
}

std::vector<Metric> Recorder::metrics() const {
  return read_metrics(readings());
}

}  // namespace parapet::solver
