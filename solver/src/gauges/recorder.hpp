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
#include "quality.hpp"
#include "recorded_start.hpp"
#include "run_readings.hpp"

namespace parapet::solver {

class Recorder {
 public:
  Recorder(const Scene& scene, const Flow& flow, const RunOptions& options);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void after_step(Flow& flow) {
    launch_.observe(flow.fluid(), flow.time());
    loads_.observe(flow.take_impulses(), flow.last_time_step(), flow.time(),
                   flow.take_strip_impulses());
    watch_events(flow);
    if (options_.profile) count_at_rest(flow.fluid());
  }
  void sample(Flow& flow);
  // Takes over what was recorded of a start that another recorder of the same flow has seen, as if
  // it had been sampled here.
  // @pre unseen by this recorder's sight, and nothing recorded yet
  void catch_up(const RecordedStart& start);
  // Whether all that is in the flow has the energy to change metrics, so that no recorder may have
  // ended the run yet: the beginning that designs share.
  bool all_moving(const Flow& flow) const;
  const GaugeScene& gauge() const { return g_; }
  const RecordedStart::Sample& last_sample() const { return last_sample_; }
  // After a sample: why the run may end there; nothing when it has to go on.
  std::optional<StopReason> ended(const Flow& flow) const;
  // @param stop_reason why the run ended
  std::vector<Metric> metrics(const Flow& flow, StopReason stop_reason) const;
  // How the design loads are spread over stems and deflectors.
  std::vector<LoadProfile> load_profiles(const Flow& flow) const;
  // Of the flow at its end.
  Quality quality(const Flow& flow) const;
  // Whether metrics could still change when the run ended, for this reason.
  bool unfinished(const Flow& flow, StopReason stop_reason) const;
  Series take_series() { return std::move(series_); }
  std::int64_t max_particles_inside_walls() const { return inside_; }
  // What a profile says of the run beyond its times. Needs RunOptions::profile.
  void add_to(Profile& profile) const;

 private:
  // Since when no metric has moved.
  struct Quiet {
    double since;  // [s]
    RunReadings readings;
  };

  // The metrics at a sample, for the profile.
  struct Moment {
    std::int64_t steps;
    RunReadings readings;
  };

  void watch_events(const Flow& flow);
  void add_sample(const RecordedStart::Sample& sample, const Fluid& fluid);
  void watch_held(std::size_t barrier, const Fluid& fluid, double time);
  RunReadings readings() const;
  BarrierLoad load_at_rest(std::size_t barrier) const;
  void count_at_rest(const Fluid& fluid);
  // Whether a metric may still change within a time [s].
  bool can_still_change(const Flow& flow, double within) const;
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
  // [n_barriers] impulse at the arrival, and from there over impulse_time once that is over [N s/m]
  std::vector<Vec2> impulse_before_;
  std::vector<std::optional<double>> impulse_;
  std::vector<HeldEvents> held_;  // [n_barriers]
  std::optional<InstantReadings> instant_;
  RecordedStart::Sample last_sample_{};
  std::int64_t particles_ = 0;  // released
  std::int64_t inside_ = 0;
  double peak_energy_ = 0.0;
  EnergyGain energy_gain_;
  double spray_share_ = 0.0, density_error_ = 0.0;  // largest
  std::optional<double> approach_depth_;            // when the flow meets the first barrier [m]
  std::optional<Quiet> quiet_;
  std::vector<Moment> moments_;
  std::int64_t particle_steps_ = 0, particle_steps_at_rest_ = 0;
};

}  // namespace parapet::solver
