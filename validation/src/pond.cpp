// Debris held at rest behind a stem that stands normal to the bed: volume, surface and thrust
// against the static limit of a thin layer on a slope. The pond starts overfilled, and what it
// cannot hold flows over the crest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "balance.hpp"
#include "cases.hpp"
#include "channel.hpp"
#include "flow_tools.hpp"
#include "parapet/reports/line_plot.hpp"
#include "particle_picture.hpp"

namespace parapet::validation {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;
using solver::InitialParticle;
using solver::Material;
using solver::Scene;

namespace {

constexpr double released = 0.06;     // volume of the channel's reservoir [m2]
constexpr double excess = 0.05;       // of the depth at the start [m]
constexpr double bin = 0.02;          // over which depths are averaged [m]
constexpr double step = 1e-4;         // of the integration [m]
constexpr double time_to_rest = 6.0;  // [s]

// Depth against the distance s upstream of the stem, where it equals the stem's height. The layer
// is about to flow downstream and the bed carries tau_y: rho g cos a h dh/dx = rho g sin a h -
// tau_y, that is dh/dx = tan a (1 - h_c/h) with h_c = tau_y/(rho g sin a) and x downstream.
// `stretching`: 0 for the thin layer; +1 or -1 adds the normal stresses, (pi/2) tau_y h, of a layer
// that is drawn out or pressed together, the theory's next order.
class StaticLimit {
 public:
  StaticLimit(const Scene& scene, double height, double length, double stretching = 0.0)
      : length_(length) {
    const Material& m = scene.material;
    const double normal = m.density * scene.gravity * std::cos(scene.slope);
    const double along = m.density * scene.gravity * std::sin(scene.slope);
    const auto slope = [&](double h) {
      return (along * h - m.yield_stress) /
             (normal * h - stretching * 0.5 * std::numbers::pi * m.yield_stress);
    };
    double h = height;
    for (double s = 0.0; s < length + step; s += step) {
      depth_.push_back(h);
      const double half = h - 0.5 * step * slope(h);
      h -= step * slope(half);
    }
  }
  double depth(double s) const {
    const double at = std::clamp(s / step, 0.0, static_cast<double>(depth_.size() - 2));
    const auto k = static_cast<std::size_t>(at);
    return depth_[k] + (at - static_cast<double>(k)) * (depth_[k + 1] - depth_[k]);
  }
  double volume() const {
    double sum = 0.0;
    const int n = static_cast<int>(std::round(length_ / step));
    for (int k = 0; k < n; ++k) sum += step * depth((k + 0.5) * step);
    return sum;
  }

 private:
  double length_;
  std::vector<double> depth_;
};

struct Pond {
  double height;   // of the stem [m]
  double length;   // from the back wall to the stem [m]
  double spacing;  // [m]
  double cutoff;   // [1/s]
  bool skimmed;    // what rises above the crest's level is taken away
};

struct Outcome {
  std::vector<double> time, volume;  // held [m2]
  std::vector<double> x, surface;    // depths at the end [m]
  double thrust = 0.0;               // on the stem, mean of the last 2 s [N/m]
  double depth_at_stem = 0.0;        // at the end [m]
  double speed = 0.0;                // largest upstream of the stem at the end [m/s]
  double mass_change = 0.0;
  int inside = 0;
  ParticlePanel panel;
  std::vector<solver::Face> walls;
};

Scene scene_of(const Pond& pond) {
  Scene scene;
  scene.domain_length = pond.length + 0.12;
  scene.material.cutoff_shear_rate = pond.cutoff;
  solver::Barrier stem;
  stem.foot_x = pond.length;
  stem.height = pond.height;
  stem.stem_lean = -scene.slope;
  scene.barriers = {stem};
  return scene;
}

Outcome computed(const Pond& pond, const CaseRun& run) {
  const Scene scene = scene_of(pond);
  const StaticLimit limit(scene, pond.height, pond.length);
  solver::Numerics numerics;
  numerics.spacing = pond.spacing;
  numerics.sound_speed = 20.0;  // ten times what falls from the crest
  FlowSetup setup = solver::channel_setup(scene, numerics, 1);
  setup.particles.clear();
  if (pond.skimmed) setup.ceiling_z = pond.height;
  for (InitialParticle p : solver::lattice_block(0.0, 0.0, pond.length, pond.height + 2.0 * excess,
                                                 pond.spacing, scene.material.density)) {
    double depth = limit.depth(pond.length - p.x) + excess;
    if (pond.skimmed) depth = std::min(depth, pond.height);
    depth -= p.z;
    if (depth <= 0.0) continue;
    p.density -= scene.material.density * setup.gravity.z * depth /
                 (numerics.sound_speed * numerics.sound_speed);
    setup.particles.push_back(p);
  }
  Flow flow(std::move(setup));
  Balance balance(flow);
  Outcome out;
  double before = 0.0;
  const auto sample = [&](Flow& now) {
    const Fluid& f = std::as_const(now).fluid();
    double mass = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
      if (f.x[i] < pond.length) mass += f.mass[i];
    }
    out.time.push_back(now.time());
    out.volume.push_back(mass / scene.material.density);
    out.inside += now.particles_inside_walls();
    if (now.time() < time_to_rest - 2.0 + 1e-9)
      before = balance.impulses().empty() ? 0.0 : balance.impulses()[0].force.x;
  };
  advance_sampled(flow, time_to_rest, 0.1, run, sample, &balance);
  const Fluid& f = std::as_const(flow).fluid();
  out.thrust = (balance.impulses()[0].force.x - before) / 2.0;
  const auto bins = static_cast<std::size_t>(std::round(pond.length / bin));
  out.surface.assign(bins, 0.0);
  for (std::size_t k = 0; k < bins; ++k) out.x.push_back((static_cast<double>(k) + 0.5) * bin);
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    if (f.x[i] >= pond.length) continue;
    out.speed = std::max(out.speed, std::hypot(f.u[i], f.w[i]));
    // a particle's mass is spread over a square of its volume
    const double side = std::sqrt(f.volume[i]), from = f.x[i] - 0.5 * side, to = from + side;
    for (std::size_t k = static_cast<std::size_t>(std::max(0.0, from / bin));
         k < bins && static_cast<double>(k) * bin < to; ++k) {
      const double left = static_cast<double>(k) * bin;
      const double overlap = std::min(to, left + bin) - std::max(from, left);
      out.surface[k] += f.mass[i] / scene.material.density * std::max(overlap, 0.0) / side / bin;
    }
  }
  out.depth_at_stem = out.surface.back();
  out.mass_change = balance.mass_change(flow);
  out.panel = speed_panel(flow, fmt::format("stem of {:.0f} mm, {}", 1e3 * pond.height,
                                            pond.skimmed ? "skimmed at the crest" : "free crest"));
  for (double& u : out.panel.quantity) u *= 1e3;
  out.walls = flow.solids().faces;
  return out;
}

// A uniform layer a quarter deeper than h_c, in rows of particles: its speed at the surface over
// the exact one of Herschel-Bulkley flow. The sheared part below the plug is a fifth of the depth.
double layer_speed(int rows, const CaseRun& run) {
  const Scene scene;
  Material material = scene.material;
  material.cutoff_shear_rate = 0.01;
  const double drive = material.density * scene.gravity * std::sin(scene.slope);
  const double h_c = material.yield_stress / drive, depth = 1.25 * h_c, n = material.flow_index;
  const double exact = n / (n + 1.0) * std::pow(drive / material.consistency, 1.0 / n) *
                       std::pow(depth - h_c, 1.0 + 1.0 / n);
  FlowSetup setup;
  setup.numerics.spacing = depth / rows;
  setup.numerics.sound_speed = 5.0;
  setup.numerics.cg_tolerance = 1e-3;
  setup.material = material;
  setup.gravity = {scene.gravity * std::sin(scene.slope), -scene.gravity * std::cos(scene.slope)};
  setup.periodic_length = 12.0 * setup.numerics.spacing;
  add_periodic_wall(setup, setup.periodic_length, 0.0, true);
  setup.particles = solver::lattice_block(0.0, 0.0, setup.periodic_length, depth,
                                          setup.numerics.spacing, material.density);
  for (InitialParticle& p : setup.particles) {
    p.u = exact * std::min(1.0, p.z / (depth - h_c));
    p.density -= material.density * setup.gravity.z * (depth - p.z) / 25.0;
  }
  Flow flow(std::move(setup));
  advance(flow, 1.0, run);
  const Fluid& f = std::as_const(flow).fluid();
  double speed = 0.0;
  int top = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    if (f.z[i] < 0.6 * depth) continue;
    speed += f.u[i];
    ++top;
  }
  return speed / top / exact;
}

std::string label(const Pond& p) {
  return fmt::format("{:.0f} mm stem, {:.3g} mm{}{}", 1e3 * p.height, 1e3 * p.spacing,
                     p.skimmed ? "" : ", free crest",
                     p.cutoff > 0.05 ? fmt::format(", cut-off {:.2g} 1/s", p.cutoff) : "");
}

std::string key_of(const Pond& p) {
  return fmt::format("{:.0f}_{:.3g}{}{}", 1e3 * p.height, 1e3 * p.spacing, p.skimmed ? "" : "_free",
                     p.cutoff > 0.05 ? "_cutoff" : "");
}

void add_pond(CaseRun& run, const Pond& pond, const Outcome& o) {
  const Scene scene = scene_of(pond);
  const StaticLimit limit(scene, pond.height, pond.length);
  const StaticLimit pressed(scene, pond.height, pond.length, -1.0);
  const std::string key = key_of(pond), of = label(pond);
  const bool judged = pond.skimmed && pond.cutoff < 0.05;
  Measure held{.key = fmt::format("volume_{}", key),
               .what = fmt::format("volume held over the formula's, {}", of),
               .value = o.volume.back() / limit.volume()};
  if (judged) {
    held.lower = 1.0;
    held.upper = pressed.volume() / limit.volume();
    held.reason = fmt::format("{}", "thin layer, and pressed together with its normal stresses");
    held.explanation = fmt::format(
        "{}",
        "the excess sits upstream, where the layer stops at more than h_c because its "
        "sheared part is thinner than a particle, and within one height of the stem, where "
        "no thin layer is left");
  }
  run.add(held);
  double sum = 0.0, upstream = 0.0, far = 0.0, near = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < o.x.size(); ++k) {
    const double from_stem = pond.length - o.x[k];
    const double difference = o.surface[k] - limit.depth(from_stem);
    sum += difference * difference;
    if (from_stem > 3.0 * pond.height) far += bin * difference;
    if (from_stem < pond.height) near += bin * difference;
    if (o.x[k] > 0.1 && o.x[k] < 0.3) {
      upstream += o.surface[k];
      ++count;
    }
  }
  run.add({.key = fmt::format("far_{}", key),
           .what = fmt::format("excess further than three heights upstream, over the formula's "
                               "volume, {}",
                               of),
           .value = 100.0 * far / limit.volume(),
           .unit = "%"});
  run.add({.key = fmt::format("near_{}", key),
           .what = fmt::format("excess within one height of the stem, over the formula's volume, "
                               "{}",
                               of),
           .value = 100.0 * near / limit.volume(),
           .unit = "%"});
  run.add({.key = fmt::format("surface_{}", key),
           .what = fmt::format("surface against the formula, rms over the stem's height, {}", of),
           .value = 100.0 * std::sqrt(sum / static_cast<double>(o.x.size())) / pond.height,
           .unit = "%"});
  if (pond.height < 0.15) {
    run.add({.key = fmt::format("upstream_{}", key),
             .what = fmt::format("depth of the layer far upstream over h_c, {}", of),
             .value = upstream / count /
                      (scene.material.yield_stress /
                       (scene.material.density * scene.gravity * std::sin(scene.slope)))});
  }
  const double h = o.depth_at_stem, weight = scene.material.density * scene.gravity;
  const double hydrostatic = 0.5 * weight * std::cos(scene.slope) * h * h;
  run.add({.key = fmt::format("thrust_{}", key),
           .what = fmt::format("thrust on the stem over the hydrostatic one of its depth, {}", of),
           .value = o.thrust / hydrostatic,
           .lower = 1.0,
           .reason = "the layer presses on the stem, it does not hang from it"});
  // along the bed: weight = thrust + friction; the back wall does not pull
  const double friction = weight * std::sin(scene.slope) * o.volume.back() - o.thrust;
  run.add({.key = fmt::format("friction_{}", key),
           .what = fmt::format("friction on the bed over tau_y times its length, {}", of),
           .value = friction / (scene.material.yield_stress * pond.length),
           .lower = 0.0,
           .upper = 1.0,
           .reason = "a bed at rest carries no more than the yield stress",
           .explanation = "beside a wall the yield stress comes out too large where the shear is "
                          "all between the wall and the first row"});
  run.add({.key = fmt::format("rest_{}", key),
           .what = fmt::format("largest speed at the end, {}", of),
           .value = 1e3 * o.speed,
           .unit = "mm/s"});
}

void draw_surfaces(CaseRun& run, const std::vector<Pond>& ponds,
                   const std::vector<Outcome>& outcomes) {
  const Pond& first = ponds.front();
  reports::LinePlot plot;
  plot.title =
      fmt::format("Pond behind a bed-normal stem of {:.0f} mm on 26 deg", 1e3 * first.height);
  plot.x_label = "distance from the back wall along the bed [m]";
  plot.y_label = "depth [mm]";
  const auto line = [&](double stretching, const char* name, reports::SeriesStyle style,
                        int color) {
    const StaticLimit limit(scene_of(first), first.height, first.length, stretching);
    reports::PlotSeries s{name, {}, {}, style, color};
    for (int k = 0; k <= 200; ++k) {
      s.x.push_back(first.length * k / 200.0);
      s.y.push_back(1e3 * limit.depth(first.length - s.x.back()));
    }
    return s;
  };
  int color = 2;
  for (std::size_t k = 0; k < ponds.size(); ++k) {
    if (ponds[k].height != first.height) continue;
    reports::PlotSeries s{
        label(ponds[k]), outcomes[k].x, {}, reports::SeriesStyle::line_and_markers, color++};
    for (const double h : outcomes[k].surface) s.y.push_back(1e3 * h);
    plot.series.push_back(s);
  }
  plot.series.push_back(line(0.0, "formula", reports::SeriesStyle::line, 1));
  plot.series.push_back(line(-1.0, "next order, pressed", reports::SeriesStyle::dashed, 0));
  plot.width_px = 900;
  plot.height_px = 500;
  draw_line_plot(run.figure("surface.png"), plot);
}

}  // namespace

void pond(CaseRun& run) {
  // the formula first: shares of the reservoir that a stem holds
  struct Share {
    double height, length, expected;
  };
  for (const Share& s :
       {Share{0.1, 0.8, 0.41}, {0.1, 1.1, 0.50}, {0.18, 0.8, 0.79}, {0.18, 1.1, 0.89}}) {
    const Scene scene = scene_of({s.height, s.length, 0.01, 0.01, true});
    run.add({.key = fmt::format("share_{:.0f}_{:.0f}", 1e3 * s.height, 1e2 * s.length),
             .what = fmt::format("formula: share of 0.06 m2 held over {:.1f} m by {:.0f} mm",
                                 s.length, 1e3 * s.height),
             .value = StaticLimit(scene, s.height, s.length).volume() / released,
             .lower = s.expected - 0.005,
             .upper = s.expected + 0.005,
             .reason = "an independent integration, two digits"});
  }
  std::vector<Pond> ponds;
  if (run.full()) {
    ponds = {{0.1, 0.8, 0.005, 0.01, true}, {0.1, 0.8, 0.0075, 0.01, true},
             {0.1, 0.8, 0.01, 0.01, true},  {0.1, 0.8, 0.0075, 0.01, false},
             {0.18, 0.8, 0.01, 0.01, true}, {0.1, 0.8, 0.01, 0.1, true}};
  } else {
    ponds = {{0.1, 0.8, 0.0125, 0.01, true}};
  }
  const std::vector<int> rows = run.full() ? std::vector{3, 6, 12, 18, 24, 32} : std::vector{3, 12};
  std::vector<Outcome> outcomes(ponds.size());
  std::vector<double> speeds(rows.size()), cost;
  for (const Pond& p : ponds) cost.push_back(3e-6 / std::pow(p.spacing, 3.0));
  run.side_by_side(
      ponds.size() + rows.size(),
      [&](std::size_t k) {
        if (k < ponds.size()) {
          outcomes[k] = computed(ponds[k], run);
        } else {
          speeds[k - ponds.size()] = layer_speed(rows[k - ponds.size()], run);
        }
      },
      cost);
  double mass = 0.0;
  int inside = 0;
  for (std::size_t k = 0; k < ponds.size(); ++k) {
    add_pond(run, ponds[k], outcomes[k]);
    mass = std::max(mass, std::abs(outcomes[k].mass_change));
    inside += outcomes[k].inside;
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    run.add({.key = fmt::format("layer_{}", rows[k]),
             .what = fmt::format("uniform layer of 1.25 h_c in {} rows: speed over the exact one",
                                 rows[k]),
             .value = speeds[k]});
  }
  run.add({.key = "mass",
           .what = "change of the mass, with what has left",
           .value = mass,
           .upper = 1e-12,
           .reason = "particles keep their mass; the sum rounds"});
  run.add({.key = "inside",
           .what = "particles inside walls",
           .value = static_cast<double>(inside),
           .upper = 0.0,
           .reason = "a wall is a wall"});
  draw_surfaces(run, ponds, outcomes);
  ParticlePicture picture;
  const std::size_t shown = run.full() ? 1 : 0;
  picture.title = fmt::format("Speed at the end, {:.3g} mm", 1e3 * ponds[shown].spacing);
  picture.quantity = "speed [mm/s]";
  picture.low = 0.0;
  picture.high = 5.0;
  picture.spacing = ponds[shown].spacing;
  picture.walls = outcomes[shown].walls;
  picture.window_from = {0.35, -0.01};
  picture.window_to = {0.84, 0.16};
  picture.panels.push_back(outcomes[shown].panel);
  if (run.full()) picture.panels.push_back(outcomes[3].panel);
  picture.columns = 1;
  picture.width_px = 760;
  draw(run, "particles.png", picture);
}

}  // namespace parapet::validation
