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

// Metrics are final before debris is at rest. Of the settled rule's window and energy, and of the
// time so far: slow flows take longer for everything.
constexpr double final_window = 0.5, final_energy = 2.0, final_time = 1.0 / 16.0;

GaugeScene gauge_scene(const Scene& scene, const Flow& flow, const GaugeSettings& settings) {
  GaugeScene g;
  g.scene = &scene;
  for (const Barrier& barrier : scene.barriers) {
    const Vec2 stem = stem_direction(scene, barrier);
    g.lines.push_back({{barrier.foot_x, 0.0}, {stem.z, -stem.x}});
    const std::vector<Vec2> outline = barrier_outline(scene, barrier);
    g.edges.push_back(
        {outline[barrier.deflector ? 2 : 1], g.lines.back().downstream});  // tip, or crest
  }
  g.gauge_x = scene.barriers.empty() ? scene.monitor_x : scene.barriers.front().foot_x;
  for (std::size_t i = 0; i < static_cast<std::size_t>(flow.fluid().n); ++i) {
    g.released_mass += flow.fluid().mass[i];
  }
  g.spacing = flow.setup().numerics.spacing;
  g.settings = settings;
  g.units = event_units(scene, settings);
  return g;
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Flow& flow, const RunOptions& options)
    : scene_(scene),
      options_(options),
      g_(gauge_scene(scene_, flow, options.gauges)),
      launch_(g_),
      loads_(scene.barriers.size(), {g_.time(options.gauges.slam_time_ratio),
                                     g_.time(options.gauges.short_load_time_ratio),
                                     g_.time(options.gauges.design_load_time_ratio)}),
      arrival_(scene.barriers.size(), -1.0),
      impulse_before_(scene.barriers.size()),
      impulse_(scene.barriers.size()),
      held_(scene.barriers.size()),
      particles_(flow.fluid().n) {
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
    for (const char* name :
         {"retention_efficiency", "run_up_height_m", "force_x_n_per_m", "force_z_n_per_m",
          "moment_nm_per_m", "deflector_force_x_n_per_m", "deflector_force_z_n_per_m"}) {
      series_.columns.push_back(b + name);
    }
  }
}

// What happens between samples.
void Recorder::watch_events(const Flow& flow) {
  const double now = flow.time();
  for (std::size_t k = 0; k < arrival_.size(); ++k) {
    const double end = arrival_[k] + g_.time(g_.settings.impulse_time_ratio);
    if (arrival_[k] < 0.0 || impulse_[k] || now < end * (1.0 - 1e-12)) continue;
    impulse_[k] = norm(loads_.impulse(k) - impulse_before_[k]);
  }
  if (options_.reading_time > 0.0 && !instant_ && now >= options_.reading_time * (1.0 - 1e-12)) {
    instant_ = read_instant(g_, flow.fluid(), 2.0 * flow.smoothing_length());
  }
}

void Recorder::sample(Flow& flow) {
  add_sample(channel_sample(g_, flow), flow.fluid());
  if (options_.profile) moments_.push_back({flow.statistics().steps, readings()});
}

void Recorder::catch_up(const RecordedStart& start) {
  const Fluid nothing_in_sight;
  const std::vector<BarrierImpulse> no_load(cells_per_barrier * g_.lines.size());
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
  if (sample.left_mass == 0.0) {
    energy_gain_.observe(sample.kinetic_energy + sample.potential_energy);
  }
  spray_share_ = std::max(spray_share_, sample.spray_share);
  density_error_ = std::max(density_error_, sample.density_error);
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
    row.push_back(dead_zone(g_, 0, f).length);
  }
  const auto loads = loads_.read();
  for (std::size_t k = 0; k < g_.lines.size(); ++k) {
    if (arrival_[k] < 0.0 &&
        mass_share_at_line(g_, g_.lines[k], f) >= g_.settings.arrival_mass_share) {
      arrival_[k] = sample.time;
      impulse_before_[k] = loads_.impulse(k);
      if (k == 0) {
        approach_depth_ =
            flow_depth_at(g_, f, g_.gauge_x - g_.length(g_.settings.front_clearance_ratio));
      }
    }
    if (arrival_[k] >= 0.0) watch_held(k, f, sample.time);
    row.push_back(retention_efficiency(g_, g_.lines[k], f, sample.left_mass));
    row.push_back(run_up_height(g_, g_.lines[k], f));
    const BarrierLoad &stem = loads[cells_per_barrier * k],
                      &deflector = loads[cells_per_barrier * k + 1];
    row.push_back(stem.force.x + deflector.force.x);
    row.push_back(stem.force.z + deflector.force.z);
    row.push_back(stem.moment + deflector.moment);
    row.push_back(deflector.force.x);
    row.push_back(deflector.force.z);
  }
  series_.rows.push_back(std::move(row));
  inside_ = std::max(inside_, sample.inside_walls);
  if (options_.settled.enabled && !options_.until_rest) watch_metrics(sample.time);
}

// From the arrival at a barrier on.
void Recorder::watch_held(std::size_t k, const Fluid& f, double time) {
  HeldEvents& events = held_[k];
  if (!events.dead_zone_onset &&
      dead_zone(g_, k, f).length >= g_.length(g_.settings.dead_zone_window_ratio)) {
    events.dead_zone_onset = time;
  }
  const Backflow now = backflow(g_, k, f);
  events.backflow.share = std::max(events.backflow.share, now.share);
  if (now.speed) {
    events.backflow.speed = std::max(events.backflow.speed.value_or(0.0), *now.speed);
  }
}

bool Recorder::unfinished(const Flow& flow, StopReason stop_reason) const {
  const bool cut_off = stop_reason != StopReason::metrics_final &&
                       stop_reason != StopReason::settled && stop_reason != StopReason::drained;
  // as long again could still bring something
  return cut_off && can_still_change(flow, flow.time());
}

Quality Recorder::quality(const Flow& flow) const {
  const double released =
      0.5 * g_.released_mass * scene_.gravity * std::cos(scene_.slope) * scene_.reservoir_height;
  const RunStatistics& statistics = flow.statistics();
  Quality quality;
  quality.energy_gain_ratio = energy_gain_.largest() / released;
  quality.density_error_max = statistics.max_density_error;
  quality.density_error_bulk = density_error_;
  quality.mass_spread = mass_spread(flow.fluid());
  quality.spray_share_max = spray_share_;
  quality.wall_contacts_per_particle =
      static_cast<double>(statistics.wall_contacts) / static_cast<double>(particles_);
  if (approach_depth_) quality.particles_across_approach = *approach_depth_ / g_.spacing;
  return quality;
}

// What passes unseen may not be more than what retention may move by.
bool Recorder::all_moving(const Flow& flow) const {
  const SettledRule& rule = options_.settled;
  return live_energy(g_, flow.fluid(), rule.retention_change) >
         final_energy * rule.kinetic_energy_share * peak_energy_;
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
bool Recorder::can_still_change(const Flow& flow, double within) const {
  const Fluid& f = flow.fluid();
  if (all_moving(flow)) return true;
  if (launch_.landing(f)) return true;
  if (flow.time() < options_.reading_time) return true;
  for (std::size_t k = 0; k < arrival_.size(); ++k) {
    if (arrival_[k] >= 0.0 && !impulse_[k]) return true;
  }
  if (g_.lines.empty()) {
    const BarrierLine end = end_of_gauge(g_);
    return front_position(g_, f, flow.left_mass()) < end.foot.x &&
           may_still_arrive(g_, end, f, within);
  }
  for (std::size_t k = 0; k < g_.lines.size(); ++k) {
    if (arrival_[k] < 0.0 && may_still_arrive(g_, g_.lines[k], f, within)) return true;
  }
  return false;
}

void Recorder::watch_metrics(double time) {
  RunReadings now = readings();
  if (!quiet_ || metric_moved(quiet_->readings, now, options_.settled.retention_change)) {
    quiet_ = Quiet{time, std::move(now)};
  }
}

bool Recorder::metrics_final(const Flow& flow) const {
  const double now = flow.time();
  return quiet_ &&
         now - quiet_->since >=
             std::max(final_window * options_.settled.window, final_time * now) &&
         !can_still_change(flow, options_.stop_time - now);
}

std::optional<StopReason> Recorder::ended(const Flow& flow) const {
  const SettledRule& rule = options_.settled;
  if (!rule.enabled || series_.rows.empty()) return std::nullopt;
  const double now = series_.rows.back().front();
  if (now < rule.earliest_time || now < rule.window) return std::nullopt;
  if (now < options_.reading_time) return std::nullopt;
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
