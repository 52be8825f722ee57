// The overflow's flight against the ballistic formula (Ng et al. 2023, doi 10.1680/jgeot.22.00199):
// launch with speed v at angle b above the horizontal from a height H over a bed that falls by a.
// The state of launch is read where the overflow passes the barrier's last edge, which is what an
// engineer would use, and on lines farther downstream, where nothing guides the flow any more.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "barrier_runs.hpp"
#include "cases.hpp"
#include "flow_tools.hpp"
#include "parapet/flow/channel.hpp"
#include "parapet/reports/line_plot.hpp"
#include "particle_picture.hpp"

namespace parapet::validation {

using solver::Flow;
using solver::Fluid;
using solver::Scene;
using solver::Vec2;

namespace {

constexpr double landing_height = 0.010;  // of a particle's centre [m]
constexpr double share = 0.01;            // of the released mass: the coherent overflow
constexpr double not_seen = std::numeric_limits<double>::quiet_NaN();

// Where the state of launch is read: at the edge, or this far downstream of the crest (vertical
// lines in the world).
constexpr std::array<double, 4> stations{0.0, 0.03, 0.06, 0.10};  // [m]

struct Overflow {
  const char* key;
  const char* name;
  SingleBarrier barrier;
  double consistency;  // Newtonian [Pa s]; 0: Table 1 debris
};

const std::vector<Overflow> overflows{
    {"thin_bare", "thin liquid, bare", {"", "", 0.1, bare}, 1.0},
    {"thin_d0", "thin liquid, 0 deg", {"", "", 0.1, 0.0}, 1.0},
    {"bare", "debris, bare", {"", "", 0.1, bare}, 0.0},
    {"d0", "debris, 0 deg", {"", "", 0.1, 0.0}, 0.0},
    {"d30", "debris, 30 deg", {"", "", 0.1, 30.0}, 0.0},
    {"d45", "debris, 45 deg", {"", "", 0.1, 45.0}, 0.0},
};

// Distance along the bed from the place of launch to where z falls to landing_height.
double flight(const Scene& scene, double height, Vec2 velocity) {
  const double g = scene.gravity, a = scene.slope, gn = g * std::cos(a);
  const double fall = std::max(height - landing_height, 0.0);
  const double t = (velocity.z + std::sqrt(velocity.z * velocity.z + 2.0 * gn * fall)) / gn;
  return velocity.x * t + 0.5 * g * std::sin(a) * t * t;
}

class Watch {
 public:
  Watch(const Scene& scene, const Flow& flow) : scene_(scene) {
    const std::vector<Vec2> outline = barrier_outline(scene, scene.barriers.front());
    const Vec2 stem = stem_direction(scene, scene.barriers.front());
    downstream_ = {stem.z, -stem.x};
    up_ = stem;
    const Vec2 edge = outline[scene.barriers.front().deflector ? 2 : 1];
    lines_ = {edge};
    for (std::size_t k = 1; k < stations.size(); ++k) {
      lines_.push_back(outline[1] + stations[k] * downstream_);
    }
    const auto n = static_cast<std::size_t>(flow.fluid().n);
    predicted_.assign(lines_.size(), std::vector<double>(n, not_seen));
    landed_.assign(n, not_seen);
    for (std::size_t i = 0; i < n; ++i) released_ += flow.fluid().mass[i];
  }

  void observe(const Flow& flow) {
    const Fluid& f = flow.fluid();
    const Vec2 foot{scene_.barriers.front().foot_x, 0.0};
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      const Vec2 p{f.x[i], f.z[i]};
      const auto id = static_cast<std::size_t>(f.id[i]);
      if (!std::isnan(landed_[id]) || dot(p - lines_[0], downstream_) < 0.0) continue;
      for (std::size_t line = 0; line < lines_.size(); ++line) {
        const Vec2 off = p - lines_[line];
        if (!std::isnan(predicted_[line][id]) || dot(off, downstream_) < 0.0) continue;
        if (line == 0 && dot(off, up_) < 0.0) continue;  // in the pocket below the plate
        predicted_[line][id] = f.x[i] + flight(scene_, f.z[i], {f.u[i], f.w[i]}) - foot.x;
      }
      if (dot(p - foot, downstream_) >= 0.0 && f.z[i] < landing_height) {
        landed_[id] = f.x[i] - foot.x;
        first_.push_back(id);
        landed_mass_ += f.mass[i];
      }
    }
  }

  bool enough() const { return landed_mass_ >= share * released_; }

  // Median of the first to land.
  double simulated() const {
    std::vector<double> x;
    for (const std::size_t id : first_) x.push_back(landed_[id]);
    return median(x);
  }
  double predicted(std::size_t line) const {
    std::vector<double> x;
    for (const std::size_t id : first_) {
      if (!std::isnan(predicted_[line][id])) x.push_back(predicted_[line][id]);
    }
    return median(x);
  }

 private:
  static double median(std::vector<double> x) {
    if (x.empty()) return not_seen;
    std::sort(x.begin(), x.end());
    return x[x.size() / 2];
  }

  const Scene& scene_;
  Vec2 downstream_, up_;
  std::vector<Vec2> lines_;
  std::vector<std::vector<double>> predicted_;  // [line][particle] from the foot [m]
  std::vector<double> landed_;                  // [particle] from the foot [m]
  std::vector<std::size_t> first_;
  double released_ = 0.0, landed_mass_ = 0.0;
};

struct Flight {
  double simulated = not_seen;
  std::array<double, stations.size()> predicted{};
  std::vector<ParticlePanel> panels;
  std::vector<solver::Face> walls;
};

Flight flown(const Overflow& overflow, double spacing, const CaseRun& run) {
  Scene scene = scene_of(overflow.barrier);
  if (overflow.consistency > 0.0) {
    scene.material.yield_stress = 0.0;
    scene.material.consistency = overflow.consistency;
    scene.material.flow_index = 1.0;
  }
  solver::Numerics numerics;
  numerics.spacing = spacing;
  Flow flow(channel_setup(scene, numerics, 1));
  Watch watch(scene, flow);
  Flight result;
  result.walls = flow.solids().faces;
  constexpr double latest = 1.5;  // [s]
  double shown = 0.7;
  while (!watch.enough() && flow.time() < latest) {
    run.check_cancelled();
    if (const auto failure = flow.step(latest - flow.time())) {
      throw std::runtime_error(failure->reason);
    }
    watch.observe(flow);
    if (flow.time() >= shown) {
      result.panels.push_back(speed_panel(flow, fmt::format("t = {:.2f} s", flow.time())));
      shown += 0.1;
    }
  }
  if (flow.time() < shown - 0.08) result.panels.pop_back();  // no two of almost the same time
  result.panels.push_back(speed_panel(flow, fmt::format("t = {:.2f} s", flow.time())));
  result.simulated = watch.simulated();
  for (std::size_t k = 0; k < stations.size(); ++k) result.predicted[k] = watch.predicted(k);
  return result;
}

void add_rows(CaseRun& run, const Overflow& overflow, const Flight& flight) {
  run.add({.key = fmt::format("{}_simulated", overflow.key),
           .what = fmt::format("{}: launch length simulated", overflow.name),
           .value = 1e3 * flight.simulated,
           .unit = "mm"});
  for (std::size_t k = 0; k < stations.size(); ++k) {
    if (std::isnan(flight.predicted[k])) continue;
    Measure m;
    m.key = fmt::format("{}_{}", overflow.key, k);
    m.what = fmt::format(
        "{}: formula over simulated, launch read {}", overflow.name,
        k == 0 ? "at the last edge" : fmt::format("{:.0f} mm beyond the crest", 1e3 * stations[k]));
    m.value = flight.predicted[k] / flight.simulated;
    if (k == 0) {
      m.lower = 0.9;
      m.upper = 1.1;
      m.reason = "what the formula is used for in design";
      m.explanation =
          "the sheet is still under pressure at the edge and holds together in flight: viscosity "
          "and yield stress pass momentum from the flow behind to the front";
    } else if (k + 1 == stations.size()) {
      m.lower = 0.9;
      m.upper = 1.1;
      m.reason = "beyond the barrier nothing but gravity acts on a thin sheet";
      m.explanation = "the tongue of debris slumps rather than flies";
    }
    run.add(m);
  }
}

}  // namespace

void ballistic(CaseRun& run) {
  const double spacing = run.full() ? 0.005 : 0.0125;
  const std::size_t count = run.full() ? overflows.size() : 3;
  std::vector<Flight> flights(count);
  run.side_by_side(
      count, [&](std::size_t k) { flights[k] = flown(overflows[k], spacing, run); },
      std::vector<double>(count, run.full() ? 15.0 : 1.0));
  reports::LinePlot plot;
  plot.title = "Ballistic formula over simulation";
  plot.x_label = "place where the launch is read, beyond the crest [mm]";
  plot.y_label = "launch length, formula over simulated [-]";
  for (std::size_t k = 0; k < count; ++k) {
    add_rows(run, overflows[k], flights[k]);
    reports::PlotSeries series{
        overflows[k].name, {}, {}, reports::SeriesStyle::line_and_markers, {}};
    for (std::size_t s = 0; s < stations.size(); ++s) {
      series.x.push_back(1e3 * stations[s]);
      series.y.push_back(flights[k].predicted[s] / flights[k].simulated);
    }
    plot.series.push_back(series);
  }
  plot.width_px = 800;
  plot.height_px = 480;
  draw_line_plot(run.figure("ratio.png"), plot);
  for (const std::size_t k : {std::size_t{1}, count - 1}) {
    ParticlePicture picture;
    picture.title = overflows[k].name;
    picture.quantity = "speed [m/s]";
    picture.high = 3.0;
    picture.spacing = spacing;
    picture.walls = flights[k].walls;
    picture.window_from = {0.7, -0.02};
    picture.window_to = {1.7, 0.5};
    picture.columns = 2;
    const auto& panels = flights[k].panels;
    const std::size_t from = panels.size() > 4 ? panels.size() - 4 : 0;
    picture.panels.assign(panels.begin() + static_cast<std::ptrdiff_t>(from), panels.end());
    draw(run, fmt::format("{}.png", overflows[k].key), picture);
  }
}

}  // namespace parapet::validation
