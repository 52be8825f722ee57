#include "recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "channel_gauge.hpp"
#include "live_material.hpp"
#include "metric_table.hpp"
#include "retention.hpp"

namespace parapet::solver {
namespace {

GaugeScene gauge_scene(const Scene& scene, const Flow& flow) {
  GaugeScene g;
  g.scene = &scene;
  for (const Barrier& barrier : scene.barriers) {
    const Vec2 stem = stem_direction(scene, barrier);
    g.lines.push_back({{barrier.foot_x, 0.0}, {stem.z, -stem.x}});
  }
  if (!scene.barriers.empty()) {
    const Barrier& first = scene.barriers.front();
    const std::vector<Vec2> outline = barrier_outline(scene, first);
    g.edge = {outline[first.deflector ? 2 : 1], g.lines.front().downstream};  // tip, or crest
  }
  g.gauge_x = scene.barriers.empty() ? scene.monitor_x : scene.barriers.front().foot_x;
  for (std::size_t i = 0; i < static_cast<std::size_t>(flow.fluid().n); ++i) {
    g.released_mass += flow.fluid().mass[i];
  }
  g.spacing = flow.setup().numerics.spacing;
  return g;
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Flow& flow, const RunOptions& options)
    : scene_(scene),
      options_(options),
      g_(gauge_scene(scene_, flow)),
      launch_(g_),
      loads_(scene.barriers.size()),
      arrival_(scene.barriers.size(), -1.0) {
  series_.columns = {"time_s",
                     "kinetic_energy_j_per_m",
                     "window_kinetic_energy_j_per_m",
                     "potential_energy_j_per_m",
                     "front_x_m",
                     "flow_depth_m",
                     "max_speed_m_s",
                     "left_mass_kg_per_m"};
  if (!scene.barriers.empty()) {
    series_.columns.push_back("landed_share");
    series_.columns.push_back("dead_zone_length_m");
  }
  for (std::size_t k = 1; k <= scene.barriers.size(); ++k) {
    const std::string b = "barrier_" + std::to_string(k) + "_";
    for (const char* name : {"retention_efficiency", "run_up_height_m", "force_x_n_per_m",
                             "force_z_n_per_m", "moment_nm_per_m"}) {
      series_.columns.push_back(b + name);
    }
  }
}

void Recorder::sample(Flow& flow) {
  add_sample(channel_sample(g_, flow), flow.fluid());
  if (options_.profile) moments_.push_back({flow.statistics().steps, readings()});
}

void Recorder::catch_up(const RecordedStart& start) {
  const Fluid nothing_in_sight;
  const std::vector<BarrierImpulse> no_load(g_.lines.size());
  auto step = start.steps.begin();
  for (const RecordedStart::Sample& sample : start.samples) {
    for (; step != start.steps.end() && step->end <= sample.time; ++step) {
      loads_.observe(no_load, step->length, step->end);
    }
    add_sample(sample, nothing_in_sight);
  }
}

// `f` may lack what no gauge can see.
void Recorder::add_sample(const RecordedStart::Sample& sample, const Fluid& f) {
  last_sample_ = sample;
  peak_energy_ = std::max(peak_energy_, sample.kinetic_energy);
  std::vector<double> row{sample.time,
                          sample.kinetic_energy,
                          window_kinetic_energy(g_, f),
                          sample.potential_energy,
                          sample.front_x,
                          flow_depth(g_, f),
                          sample.max_speed,
                          sample.left_mass};
  if (!g_.lines.empty()) {
    row.push_back(launch_.landed_share());
    row.push_back(dead_zone_length(g_, f));
  }
  const auto loads = loads_.read();
  for (std::size_t k = 0; k < g_.lines.size(); ++k) {
    if (arrival_[k] < 0.0 && mass_share_at_line(g_, g_.lines[k], f) >= 0.005) {
      arrival_[k] = sample.time;
    }
    row.push_back(retention_efficiency(g_, g_.lines[k], f, sample.left_mass));
    row.push_back(run_up_height(g_, g_.lines[k], f));
    row.push_back(loads[k].force.x);
    row.push_back(loads[k].force.z);
    row.push_back(loads[k].moment);
  }
  series_.rows.push_back(std::move(row));
  inside_ = std::max(inside_, sample.inside_walls);
  if (options_.settled.enabled && !options_.until_rest) watch_metrics(sample.time);
}

bool Recorder::all_moving(const Flow& flow) const {
  const SettledRule& rule = options_.settled;
  return live_energy(g_, flow.fluid(), rule.retention_change) >
         rule.kinetic_energy_share * peak_energy_;
}

void Recorder::count_at_rest(const Fluid& f) {
  constexpr double share = 0.01;  // of the speed of a fall from the reservoir's height
  const double rest2 = share * share * 2.0 * scene_.gravity * scene_.reservoir_height;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    particle_steps_at_rest_ += f.u[i] * f.u[i] + f.w[i] * f.w[i] < rest2;
  }
  particle_steps_ += f.n;
}

void Recorder::add_to(Profile& profile) const {
  if (moments_.empty() || particle_steps_ == 0) return;
  profile.rest_share =
      static_cast<double>(particle_steps_at_rest_) / static_cast<double>(particle_steps_);
  const Moment& end = moments_.back();
  std::size_t last = moments_.size() - 1;  // the first moment with the metrics of the end
  while (last > 0 && !metric_moved(moments_[last - 1].readings, end.readings,
                                   options_.settled.retention_change)) {
    --last;
  }
  profile.steps_after_last_change =
      static_cast<double>(end.steps - moments_[last].steps) / static_cast<double>(end.steps);
}

double Recorder::value(std::size_t row, const std::string& name) const {
  const auto at = std::find(series_.columns.begin(), series_.columns.end(), name);
  return series_.rows[row][static_cast<std::size_t>(at - series_.columns.begin())];
}

std::vector<double> Recorder::column(const std::string& name) const {
  const auto at = std::find(series_.columns.begin(), series_.columns.end(), name);
  const auto place = static_cast<std::size_t>(at - series_.columns.begin());
  std::vector<double> values;
  for (const std::vector<double>& row : series_.rows) values.push_back(row[place]);
  return values;
}

// A metric can change while material that it sees has energy, while the overflow is landing, and
// while slow debris is still on its way to a place that it has not reached.
bool Recorder::can_still_change(const Flow& flow) const {
  const Fluid& f = flow.fluid();
  const SettledRule& rule = options_.settled;
  // what passes unseen may not be more than what retention may move by
  const double energy = live_energy(g_, f, rule.retention_change);
  if (energy > rule.kinetic_energy_share * peak_energy_) return true;
  if (launch_.landing(f)) return true;
  const double left = options_.stop_time - flow.time();
  if (g_.lines.empty()) {
    const BarrierLine end = end_of_gauge(g_);
    return front_position(g_, f, flow.left_mass()) < end.foot.x &&
           may_still_arrive(g_, end, f, left);
  }
  for (std::size_t k = 0; k < g_.lines.size(); ++k) {
    if (arrival_[k] < 0.0 && may_still_arrive(g_, g_.lines[k], f, left)) return true;
  }
  return false;
}

void Recorder::watch_metrics(double time) {
  RunReadings now = readings();
  if (!quiet_ || metric_moved(quiet_->readings, now, options_.settled.retention_change)) {
    quiet_ = Quiet{time, std::move(now)};
  }
}

// Slow flows take longer for everything: an eighth of the time so far must have changed nothing.
bool Recorder::metrics_final(const Flow& flow) const {
  constexpr double quiet_share = 1.0 / 8.0;
  const double now = flow.time();
  return quiet_ && now - quiet_->since >= std::max(options_.settled.window, quiet_share * now) &&
         !can_still_change(flow);
}

std::optional<StopReason> Recorder::ended(const Flow& flow) const {
  const SettledRule& rule = options_.settled;
  if (!rule.enabled || series_.rows.empty()) return std::nullopt;
  const double now = series_.rows.back().front();
  if (now < rule.earliest_time || now < rule.window) return std::nullopt;
  if (options_.until_rest) return at_rest(now) ? std::optional(StopReason::settled) : std::nullopt;
  return metrics_final(flow) ? std::optional(StopReason::metrics_final) : std::nullopt;
}

bool Recorder::at_rest(double now) const {
  const SettledRule& rule = options_.settled;
  std::vector<double> low(g_.lines.size(), 2.0), high(g_.lines.size(), -1.0);
  for (std::size_t r = series_.rows.size(); r-- > 0;) {
    if (series_.rows[r].front() < now - rule.window) break;
    if (series_.rows[r][1] > rule.kinetic_energy_share * peak_energy_) return false;
    for (std::size_t k = 0; k < g_.lines.size(); ++k) {
      const double retained =
          value(r, "barrier_" + std::to_string(k + 1) + "_retention_efficiency");
      low[k] = std::min(low[k], retained);
      high[k] = std::max(high[k], retained);
    }
  }
  for (std::size_t k = 0; k < g_.lines.size(); ++k) {
    if (high[k] - low[k] > rule.retention_change) return false;
  }
  return true;
}

}  // namespace parapet::solver
