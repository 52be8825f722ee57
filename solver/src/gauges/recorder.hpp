// Records a run: the time series, whether it has ended, and the metrics at its end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "barrier_load.hpp"
#include "gauge_scene.hpp"
#include "launch.hpp"
#include "parapet/flow/flow.hpp"
#include "parapet/solver/simulation.hpp"
#include "run_readings.hpp"

namespace parapet::solver {

class Recorder {
 public:
  Recorder(const Scene& scene, const Flow& flow, const RunOptions& options);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void after_step(Flow& flow) {
    launch_.observe(flow.fluid(), flow.time());
    loads_.observe(flow.take_impulses(), flow.last_time_step(), flow.time());
  }
  void sample(Flow& flow);
  // After a sample: why the run may end there; nothing when it has to go on.
  std::optional<StopReason> ended(const Flow& flow) const;
  std::vector<Metric> metrics() const;
  Series take_series() { return std::move(series_); }
  std::int64_t max_particles_inside_walls() const { return inside_; }

 private:
  // Since when no metric has moved.
  struct Quiet {
    double since;  // [s]
    RunReadings readings;
  };

  RunReadings readings() const;
  bool can_still_change(const Flow& flow) const;
  void watch_metrics(double time);
  bool metrics_final(const Flow& flow) const;
  bool at_rest(double now) const;
  double value(std::size_t row, const std::string& column) const;
  std::vector<double> column(const std::string& name) const;

  Scene scene_;
  RunOptions options_;
  GaugeScene g_;
  LaunchGauge launch_;
  LoadGauge loads_;
  Series series_;
  std::vector<double> arrival_;  // [n_barriers] s, negative until then
  std::int64_t inside_ = 0;
  double peak_energy_ = 0.0;
  std::optional<Quiet> quiet_;
};

}  // namespace parapet::solver
