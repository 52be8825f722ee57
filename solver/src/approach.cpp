#include "parapet/solver/approach.hpp"

#include <algorithm>
#include <cmath>

#include "gauges/gauge_scene.hpp"
#include "gauges/run_readings.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::solver {
namespace {

// Places along the channel: so many in a window of depth, and no more than so many in all.
constexpr int places_per_window = 4;
constexpr double most_places = 4000.0;

// The largest mean depth over a window, seen so far, at the ends of cells along the bed.
class DepthGauge {
 public:
  DepthGauge(double length, double window, double density)
      : cell_(std::max(window / places_per_window, length / most_places)),
        per_window_(static_cast<std::size_t>(std::max(1.0, std::round(window / cell_)))),
        density_(density),
        mass_(static_cast<std::size_t>(std::floor(length / cell_)) + 1),
        largest_(mass_.size(), 0.0) {}

  void observe(const Frame& frame) {
    std::fill(mass_.begin(), mass_.end(), 0.0);
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
      const double cell = std::floor(frame.x[i] / cell_);
      if (cell < 0.0 || cell >= static_cast<double>(mass_.size())) continue;
      mass_[static_cast<std::size_t>(cell)] += frame.mass[i];
    }
    const double per_depth = density_ * cell_ * static_cast<double>(per_window_);
    for (std::size_t k = per_window_; k < mass_.size(); ++k) {
      double mass = 0.0;
      for (std::size_t back = 1; back <= per_window_; ++back) mass += mass_[k - back];
      largest_[k] = std::max(largest_[k], mass / per_depth);
    }
  }

  std::size_t places() const { return largest_.size(); }
  double place(std::size_t k) const { return static_cast<double>(k) * cell_; }
  double depth(std::size_t k) const { return largest_[k]; }

 private:
  double cell_;
  std::size_t per_window_;
  double density_;
  std::vector<double> mass_, largest_;  // [n_places]; a place is the upstream end of its cell
};

std::vector<double> column(const Series& series, std::string_view name) {
  const auto at = std::find(series.columns.begin(), series.columns.end(), name);
  const auto place = static_cast<std::size_t>(at - series.columns.begin());
  std::vector<double> values;
  for (const std::vector<double>& row : series.rows) values.push_back(row[place]);
  return values;
}

std::optional<double> between(const std::optional<double>& a, const std::optional<double>& b,
                              double share) {
  if (share == 0.0) return a;
  if (share == 1.0) return b;
  if (!a || !b) return std::nullopt;
  return *a + share * (*b - *a);
}

}  // namespace

std::optional<double> Approach::froude_number(const Scene& scene) const {
  if (!front_velocity || !depth) return std::nullopt;
  return *front_velocity / std::sqrt(scene.gravity * std::cos(scene.slope) * *depth);
}

Approach ApproachProfile::at(double place) const {
  if (x.empty() || place < x.front() || place > x.back()) return {};
  const auto next = std::upper_bound(x.begin(), x.end() - 1, place);
  const auto k = static_cast<std::size_t>(next - x.begin());
  if (k == 0) return places.front();
  const double share = (place - x[k - 1]) / (x[k] - x[k - 1]);
  return {between(places[k - 1].front_velocity, places[k].front_velocity, share),
          between(places[k - 1].depth, places[k].depth, share)};
}

Scene undisturbed(const Scene& scene) {
  Scene open = scene;
  if (!scene.barriers.empty()) open.monitor_x = scene.barriers.back().foot_x;
  open.barriers.clear();
  return open;
}

UndisturbedRun simulate_undisturbed(const Scene& open, const Numerics& numerics,
                                    const RunOptions& options,
                                    const std::function<bool(const Progress&)>& on_progress) {
  RunOptions run = options;
  run.reading_time = 0.0;
  run.frame_interval = run.series_interval;  // frames at the samples of the series
  run.frame_times = {};
  run.until_rest = run.profile = false;
  run.approach = {};
  GaugeScene gauge;  // of an open channel
  gauge.scene = &open;
  gauge.settings = run.gauges;
  gauge.units = event_units(open, run.gauges);
  DepthGauge depth(open.domain_length, gauge.length(run.gauges.depth_window_ratio),
                   open.material.density);
  Callbacks callbacks;
  callbacks.on_progress = on_progress;
  callbacks.on_frame = [&](const Frame& frame) { depth.observe(frame); };
  UndisturbedRun made{simulate(open, numerics, run, callbacks), {}};
  if (made.result.status != Status::ok) return made;
  const std::vector<double> time = column(made.result.series, "time_s"),
                            front = column(made.result.series, "front_x_m");
  for (std::size_t k = 0; k < depth.places(); ++k) {
    gauge.gauge_x = depth.place(k);
    Approach here{front_passage(gauge, time, front).speed, {}};
    if (depth.depth(k) > 0.0) here.depth = depth.depth(k);
    made.profile.x.push_back(gauge.gauge_x);
    made.profile.places.push_back(here);
  }
  return made;
}

}  // namespace parapet::solver
