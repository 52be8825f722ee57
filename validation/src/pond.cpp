// Debris held at rest behind a stem that stands normal to the bed: volume, surface and thrust
// against the static limit of a thin layer on a slope. The pond starts overfilled, and what it
// cannot hold flows over the crest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cases.hpp"
#include "parapet/reports/line_plot.hpp"
#include "pond_flow.hpp"

namespace parapet::validation {

using ponds::Outcome;
using ponds::Pond;
using ponds::StaticLimit;
using solver::Scene;

namespace {

constexpr double released = 0.06;  // volume of the channel's reservoir [m2]

std::string label(const Pond& p) {
  return fmt::format("{:.0f} mm stem, {:.3g} mm{}{}", 1e3 * p.height, 1e3 * p.spacing,
                     p.skimmed ? "" : ", free crest",
                     p.cutoff > 0.05 ? fmt::format(", cut-off {:.2g} 1/s", p.cutoff) : "");
}

std::string key_of(const Pond& p) {
  std::string key = fmt::format("{:.0f}_{:.3g}{}{}", 1e3 * p.height, 1e3 * p.spacing,
                                p.skimmed ? "" : "_free", p.cutoff > 0.05 ? "_cutoff" : "");
  std::replace(key.begin(), key.end(), '.', 'p');  // a dot would name another case
  return key;
}

void add_pond(CaseRun& run, const Pond& pond, const Outcome& o) {
  const Scene scene = ponds::scene_of(pond);
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
    held.reason = fmt::format("{}", "the formula without and with normal stresses");
    held.explanation = fmt::format(
        "{}",
        "the excess sits upstream, where the layer stops at more than h_c (cause open: see the "
        "text), and within one height of the stem, where no thin layer is left");
  }
  run.add(held);
  double sum = 0.0, upstream = 0.0, far = 0.0, near = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < o.x.size(); ++k) {
    const double from_stem = pond.length - o.x[k];
    const double difference = o.surface[k] - limit.depth(from_stem);
    sum += difference * difference;
    if (from_stem > 3.0 * pond.height) far += ponds::bin * difference;
    if (from_stem < pond.height) near += ponds::bin * difference;
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
           .reason = "the layer pushes against the stem, it does not pull at it"});
  // along the bed: weight = thrust + friction; the back wall does not pull
  const double friction = weight * std::sin(scene.slope) * o.volume.back() - o.thrust;
  run.add({.key = fmt::format("friction_{}", key),
           .what = fmt::format("friction on the bed over tau_y times its length, {}", of),
           .value = friction / (scene.material.yield_stress * pond.length),
           .lower = 0.0,
           .upper = 1.0,
           .reason = "a bed at rest carries no more than the yield stress",
           .explanation = "a plug on a wall meets 1.06 tau_y (case slip_planes)"});
  run.add({.key = fmt::format("rest_{}", key),
           .what = fmt::format("largest speed at the end, {}", of),
           .value = 1e3 * o.speed,
           .unit = "mm/s"});
}

void draw_surfaces(CaseRun& run, const std::vector<Pond>& list,
                   const std::vector<Outcome>& outcomes) {
  const Pond& first = list.front();
  reports::LinePlot plot;
  plot.title =
      fmt::format("Pond behind a bed-normal stem of {:.0f} mm on 26 deg", 1e3 * first.height);
  plot.x_label = "distance from the back wall along the bed [m]";
  plot.y_label = "depth [mm]";
  const auto line = [&](double stretching, const char* name, reports::SeriesStyle style,
                        int color) {
    const StaticLimit limit(ponds::scene_of(first), first.height, first.length, stretching);
    reports::PlotSeries s{name, {}, {}, style, color};
    for (int k = 0; k <= 200; ++k) {
      s.x.push_back(first.length * k / 200.0);
      s.y.push_back(1e3 * limit.depth(first.length - s.x.back()));
    }
    return s;
  };
  int color = 2;
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (list[k].height != first.height) continue;
    reports::PlotSeries s{
        label(list[k]), outcomes[k].x, {}, reports::SeriesStyle::line_and_markers, color++};
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
    const Scene scene = ponds::scene_of({s.height, s.length, 0.01, 0.01, true});
    run.add({.key = fmt::format("share_{:.0f}_{:.0f}", 1e3 * s.height, 1e2 * s.length),
             .what = fmt::format("formula: share of 0.06 m2 held over {:.1f} m by {:.0f} mm",
                                 s.length, 1e3 * s.height),
             .value = StaticLimit(scene, s.height, s.length).volume() / released,
             .lower = s.expected - 0.005,
             .upper = s.expected + 0.005,
             .reason = "an independent integration, two digits"});
  }
  std::vector<Pond> list;
  if (run.full()) {
    list = {{0.1, 0.8, 0.005, 0.01, true}, {0.1, 0.8, 0.0075, 0.01, true},
            {0.1, 0.8, 0.01, 0.01, true},  {0.1, 0.8, 0.0075, 0.01, false},
            {0.18, 0.8, 0.01, 0.01, true}, {0.1, 0.8, 0.01, 0.1, true}};
  } else {
    list = {{0.1, 0.8, 0.0125, 0.01, true}};
  }
  const std::vector<int> rows = run.full() ? std::vector{3, 6, 12, 18, 24, 32} : std::vector{3, 12};
  std::vector<Outcome> outcomes(list.size());
  std::vector<double> speeds(rows.size()), cost;
  for (const Pond& p : list) cost.push_back(3e-6 / std::pow(p.spacing, 3.0));
  run.side_by_side(
      list.size() + rows.size(),
      [&](std::size_t k) {
        if (k < list.size()) {
          outcomes[k] = ponds::computed(list[k], run);
        } else {
          speeds[k - list.size()] = ponds::layer_speed(rows[k - list.size()], run);
        }
      },
      cost);
  double mass = 0.0;
  int inside = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    add_pond(run, list[k], outcomes[k]);
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
  draw_surfaces(run, list, outcomes);
  ParticlePicture picture;
  const std::size_t shown = run.full() ? 1 : 0;
  picture.title = fmt::format("Speed at the end, {:.3g} mm", 1e3 * list[shown].spacing);
  picture.quantity = "speed [mm/s]";
  picture.low = 0.0;
  picture.high = 5.0;
  picture.spacing = list[shown].spacing;
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
