#include "launch.hpp"

#include <algorithm>
#include <cmath>

#include "bed.hpp"

namespace parapet::solver {
void LaunchGauge::observe(const Fluid& f, double time) {
  if (g_.lines.empty()) return;
  const BarrierLine& line = g_.lines.front();
  const BarrierLine& edge = g_.edges.front();
  const Vec2 up{-edge.downstream.z, edge.downstream.x};
  const double approach_height = g_.length(g_.settings.approach_height_ratio);
  const double landing_height = g_.length(g_.settings.landing_height_ratio);
  if (passed_.empty()) {
    passed_.assign(static_cast<std::size_t>(f.n), 0);
    landed_ = passed_;
    passages_.resize(passed_.size());
    approach_speed_.assign(passed_.size(), -1.0);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const Vec2 p{f.x[i], f.z[i]};
    if (edge.offset(p) < 0.0) continue;
    const auto id = static_cast<std::size_t>(f.id[i]);
    if (!passed_[id] && dot(p - edge.foot, up) > 0.0) {
      passed_[id] = 1;
      passages_[id] = {f.x[i], f.z[i], f.u[i], f.w[i]};
      lately_.push_back({time, f.mass[i], f.mass[i] * Vec2{f.u[i], f.w[i]}});
      passed_mass_ += f.mass[i];
    }
    if (landed_[id] || line.offset(p) < 0.0) continue;
    const double above = f.z[i] - bed_below(*g_.scene, p);
    if (approach_speed_[id] < 0.0 && above < approach_height) {
      approach_speed_[id] = std::hypot(f.u[i], f.w[i]);
    }
    if (above < landing_height) {
      landed_[id] = 1;
      landings_.push_back({time, f.mass[i], f.x[i], approach_speed_[id], f.id[i]});
      landed_mass_ += f.mass[i];
    }
  }
  watch_sheet(time);
}

// Sums anew, so that nothing drifts; a window holds few particles.
void LaunchGauge::watch_sheet(double time) {
  const double window = g_.time(g_.settings.discharge_time_ratio);
  while (!lately_.empty() && lately_.front().time <= time - window) lately_.pop_front();
  Discharge now;
  for (const Passed& p : lately_) {
    now.mass += p.mass;
    now.momentum = now.momentum + p.momentum;
  }
  if (now.mass > largest_.mass) largest_ = now;
}

std::optional<LaunchGauge::Sheet> LaunchGauge::sheet() const {
  const double speed = largest_.mass > 0.0 ? norm(largest_.momentum) / largest_.mass : 0.0;
  if (passed_mass_ < impact_mass() || !(speed > 0.0)) return std::nullopt;
  const double window = g_.time(g_.settings.discharge_time_ratio);
  return Sheet{speed, largest_.mass / (g_.scene->material.density * window * speed)};
}

bool LaunchGauge::landing(const Fluid& f) const {
  if (landed_.empty() || landed_mass_ >= place_mass()) return false;
  const double rest_speed = g_.speed(g_.settings.rest_speed_ratio);
  double flying = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const Vec2 p{f.x[i], f.z[i]};
    if (landed_[static_cast<std::size_t>(f.id[i])] || g_.lines.front().offset(p) < 0.0) continue;
    if (std::hypot(f.u[i], f.w[i]) >= rest_speed) flying += f.mass[i];
  }
  return flying > 0.0 && landed_mass_ + flying >= impact_mass();
}

std::vector<LaunchGauge::Landing> LaunchGauge::first_landings() const {
  std::vector<Landing> first;
  double mass = 0.0;
  for (const Landing& landing : landings_) {
    if (mass >= place_mass()) break;
    mass += landing.mass;
    first.push_back(landing);
  }
  return first;
}

std::optional<LaunchGauge::Impact> LaunchGauge::impact() const {
  if (landed_mass_ < impact_mass()) return std::nullopt;
  Impact impact{0.0, 0.0, 0.0};
  std::vector<Landing> first = first_landings();
  double mass = 0.0, momentum = 0.0;
  bool reached = false;
  for (const Landing& landing : first) {
    mass += landing.mass;
    momentum += landing.mass * landing.speed;
    if (!reached && mass >= impact_mass()) {
      reached = true;
      impact.time = landing.time;
    }
  }
  impact.landing_speed = momentum / mass;
  std::sort(first.begin(), first.end(),
            [](const Landing& a, const Landing& b) { return a.x < b.x; });
  double below = 0.0;
  for (const Landing& landing : first) {
    below += landing.mass;
    impact.x = landing.x;
    if (below >= 0.5 * mass) break;
  }
  return impact;
}

std::optional<LaunchGauge::Launch> LaunchGauge::launch() const {
  if (landed_mass_ < impact_mass()) return std::nullopt;
  double mass = 0.0, height = 0.0, place = 0.0;
  Vec2 momentum;
  for (const Landing& landing : first_landings()) {
    const auto id = static_cast<std::size_t>(landing.id);
    if (!passed_[id]) continue;
    const Passage& p = passages_[id];
    mass += landing.mass;
    height += landing.mass * p.z;
    place += landing.mass * p.x;
    momentum = momentum + landing.mass * Vec2{p.u, p.w};
  }
  if (!(mass > 0.0)) return std::nullopt;
  // the world's horizontal, downstream, in channel axes
  const double a = g_.scene->slope;
  const double across = momentum.x * std::cos(a) + momentum.z * std::sin(a);
  const double up = -momentum.x * std::sin(a) + momentum.z * std::cos(a);
  return Launch{norm(momentum) / mass, std::atan2(up, across), height / mass, place / mass};
}

}  // namespace parapet::solver
