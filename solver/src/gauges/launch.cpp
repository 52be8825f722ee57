#include "launch.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::solver {
namespace {

constexpr double impact_share = 0.005;  // of the released mass
constexpr double place_share = 0.010;
constexpr double landing_height = 0.010;   // [m] of a particle's centre
constexpr double approach_height = 0.020;  // [m]
constexpr double rest_share = 0.1;  // of the speed of a fall from the crest: slower, it lies there

}  // namespace

LaunchGauge::LaunchGauge(const GaugeScene& g)
    : g_(g), landing_height_(std::max(landing_height, g.spacing)) {}

void LaunchGauge::observe(const Fluid& f, double time) {
  if (g_.lines.empty()) return;
  const BarrierLine& line = g_.lines.front();
  const Vec2 up{-g_.edge.downstream.z, g_.edge.downstream.x};
  if (passed_.empty()) {
    passed_.assign(static_cast<std::size_t>(f.n), 0);
    landed_ = passed_;
    passages_.resize(passed_.size());
    approach_speed_.assign(passed_.size(), -1.0);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const Vec2 p{f.x[i], f.z[i]};
    if (g_.edge.offset(p) < 0.0) continue;
    const auto id = static_cast<std::size_t>(f.id[i]);
    if (!passed_[id] && dot(p - g_.edge.foot, up) > 0.0) {
      passed_[id] = 1;
      passages_[id] = {f.x[i], f.z[i], f.u[i], f.w[i]};
    }
    if (landed_[id] || line.offset(p) < 0.0) continue;
    if (approach_speed_[id] < 0.0 && f.z[i] < std::max(approach_height, 2.0 * g_.spacing)) {
      approach_speed_[id] = std::hypot(f.u[i], f.w[i]);
    }
    if (f.z[i] < landing_height_) {
      landed_[id] = 1;
      landings_.push_back({time, f.mass[i], f.x[i], approach_speed_[id], f.id[i]});
      landed_mass_ += f.mass[i];
    }
  }
}

bool LaunchGauge::landing(const Fluid& f) const {
  if (landed_.empty() || landed_mass_ >= place_share * g_.released_mass) return false;
  const double fall = std::sqrt(g_.scene->gravity * g_.scene->barriers.front().height);
  double flying = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    const Vec2 p{f.x[i], f.z[i]};
    if (landed_[static_cast<std::size_t>(f.id[i])] || g_.lines.front().offset(p) < 0.0) continue;
    if (std::hypot(f.u[i], f.w[i]) >= rest_share * fall) flying += f.mass[i];
  }
  return flying > 0.0 && landed_mass_ + flying >= impact_share * g_.released_mass;
}

std::vector<LaunchGauge::Landing> LaunchGauge::first_landings() const {
  std::vector<Landing> first;
  double mass = 0.0;
  for (const Landing& landing : landings_) {
    if (mass >= place_share * g_.released_mass) break;
    mass += landing.mass;
    first.push_back(landing);
  }
  return first;
}

std::optional<LaunchGauge::Impact> LaunchGauge::impact() const {
  if (landed_mass_ < impact_share * g_.released_mass) return std::nullopt;
  Impact impact{0.0, 0.0, 0.0};
  std::vector<Landing> first = first_landings();
  double mass = 0.0, momentum = 0.0;
  bool reached = false;
  for (const Landing& landing : first) {
    mass += landing.mass;
    momentum += landing.mass * landing.speed;
    if (!reached && mass >= impact_share * g_.released_mass) {
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
  if (landed_mass_ < impact_share * g_.released_mass) return std::nullopt;
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
