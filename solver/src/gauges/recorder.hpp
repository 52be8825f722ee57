// Records a run: the time series, whether it has settled, and the metrics at its end.
#pragma once

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
  Recorder(const Scene& scene, const Flow& flow);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void after_step(Flow& flow) {
    launch_.observe(flow.fluid(), flow.time());
    loads_.observe(flow.take_impulses(), flow.last_time_step(), flow.time());
  }
  void sample(Flow& flow);
  bool settled(const SettledRule& rule) const;
  std::vector<Metric> metrics() const;
  Series take_series() { return std::move(series_); }
  std::int64_t max_particles_inside_walls() const { return inside_; }

 private:
  RunReadings readings() const;
  double value(std::size_t row, const std::string& column) const;
  std::vector<double> column(const std::string& name) const;

  Scene scene_;
  GaugeScene g_;
  LaunchGauge launch_;
  LoadGauge loads_;
  Series series_;
  std::vector<double> arrival_;  // [n_barriers] s, negative until then
  std::int64_t inside_ = 0;
  double peak_energy_ = 0.0;
};

}  // namespace parapet::solver
