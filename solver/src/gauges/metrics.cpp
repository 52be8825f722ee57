// The metrics at the end of a run: its readings, and the table's gauges applied to them.
#include <algorithm>
#include <cmath>

#include "metric_table.hpp"
#include "recorder.hpp"
#include "run_readings.hpp"

namespace parapet::solver {

// What the particles do not resolve is not told, nor what a longer run might still bring.
Reading read(const MetricEntry& entry, const RunReadings& run, std::size_t barrier) {
  constexpr double rounding = 1e-9;
  const Reading reading = entry.gauge(run, barrier);
  // what no run of this case could have stays the reason
  const bool impossible = !reading.value && !reading.absent->may_come &&
                          reading.absent->kind == Absence::does_not_exist;
  if (impossible) return reading;
  const double coarsest = entry.coarsest ? entry.coarsest(run.settings) * run.event_length : 1e300;
  if (run.spacing > coarsest * (1.0 + rounding)) return *entry.coarse_reason;
  if (entry.mass_share &&
      entry.mass_share(run.settings) * run.particles < fewest_in_share * (1.0 - rounding)) {
    return absence::too_few;
  }
  if (reading.value || !run.unfinished || !reading.absent->may_come) return reading;
  return absence::run_too_short;
}

std::vector<Metric> read_metrics(const RunReadings& run) {
  std::vector<Metric> metrics;
  for_each_metric(
      run.barriers.size(), [&](std::string key, const MetricEntry& entry, std::size_t k) {
        const Reading reading = read(entry, run, k);
        Metric metric{.key = std::move(key), .value = reading.value, .absent_reason = {}};
        if (!reading.value) {
          metric.absent_reason = reading.absent->text;
          metric.absence = reading.absent->kind;
        }
        metrics.push_back(std::move(metric));
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
  run.settings = g_.settings;
  run.event_length = g_.units.length;
  run.spacing = g_.spacing;
  run.particles = static_cast<double>(particles_);
  run.gravity = scene_.gravity;
  run.slope = scene_.slope;
  run.density = scene_.material.density;
  run.released_volume = g_.released_mass / scene_.material.density;
  run.front = front_passage(g_, time, column("front_x_m"));
  const bool met = !arrival_.empty() && arrival_.front() >= 0.0;
  run.energy = energy_phases(
      time, column("window_kinetic_energy_j_per_m"),
      met ? arrival_.front() + g_.time(g_.settings.first_peak_time_ratio) : time.back());
  if (n_barriers == 0) {
    const std::vector<double> depth = column("flow_depth_m");
    const auto deepest = std::max_element(depth.begin(), depth.end());
    run.deepest = {*deepest, time[static_cast<std::size_t>(deepest - depth.begin())]};
    return run;
  }

  const Barrier& first = scene_.barriers.front();
  run.first_foot_x = first.foot_x;
  if (first.deflector) run.deflector_length = first.deflector->length;
  run.peak_loss_rate = peak_loss_rate(time, column("barrier_1_retention_efficiency"),
                                      g_.time(g_.settings.discharge_time_ratio));
  run.impact = launch_.impact();
  run.launch = launch_.launch();
  run.sheet = launch_.sheet();
  run.instant = instant_;
  run.instant_wanted = options_.reading_time > 0.0;
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
    barrier.loads = loads_.loads()[k];
    barrier.impulse = impulse_[k];
    barrier.events = held_[k];
    if (k < options_.approach.size()) barrier.approach = options_.approach[k];
    const BarrierLoad& design = barrier.loads.design;
    const double pushing = dot(design.force, g_.lines[k].downstream);
    if (pushing > 0.0) barrier.load_height = design.moment / pushing;
  }
  return run;
}

// Mean over the settle rule's window.
BarrierLoad Recorder::load_at_rest(std::size_t k) const {
  const std::string b = "barrier_" + std::to_string(k + 1) + "_";
  const std::vector<double> time = column("time_s"), x = column(b + "force_x_n_per_m"),
                            z = column(b + "force_z_n_per_m"), m = column(b + "moment_nm_per_m");
  BarrierLoad sum;
  int samples = 0;
  for (std::size_t r = time.size(); r-- > 0 && time[r] > time.back() - options_.settled.window;) {
    sum.force = sum.force + Vec2{x[r], z[r]};
    sum.moment += m[r];
    ++samples;
  }
  const double each = 1.0 / std::max(1, samples);
  return {each * sum.force, each * sum.moment};
}

std::vector<Metric> Recorder::metrics(const Flow& flow, StopReason stop_reason) const {
  RunReadings run = readings();
  run.unfinished = unfinished(flow, stop_reason);
  if (stop_reason == StopReason::settled && options_.until_rest) {
    for (std::size_t k = 0; k < run.barriers.size(); ++k) run.barriers[k].at_rest = load_at_rest(k);
  }
  const double reach = 2.0 * flow.smoothing_length();
  for (std::size_t k = 0; k < run.barriers.size(); ++k) {
    run.barriers[k].held = {dead_zone(g_, k, flow.fluid()), ramp(g_, k, flow.fluid(), reach)};
  }
  return read_metrics(run);
}

}  // namespace parapet::solver
