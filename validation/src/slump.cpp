// A heap of debris that slumps on a flat bed beside a wall until its yield stress arrests it:
// run-out and profile against thin-layer theory, which is quasi-static, and against the theory's
// next order, which says how far the thin layer can be trusted. The creep that the cut-off of the
// viscosity allows is measured, and what the cut-off does to the run-out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "parapet/reports/line_plot.hpp"
#include "slump_flow.hpp"

namespace parapet::validation {

using slumps::Arrested;
using slumps::Heap;
using slumps::Outcome;
using slumps::Slump;
using solver::Material;

namespace {

// In a page a dot would name another case.
std::string without_dots(std::string key) {
  std::replace(key.begin(), key.end(), '.', 'p');
  return key;
}

// Table 1's debris, and one of a sixth of its yield stress, which makes a longer and thinner heap.
const Heap& table1() {
  static const Heap heap{"table1", "Table 1 (90 Pa)", 90.0, {{45.0, 6.0}, {4.526, 14.0}}};
  return heap;
}
const Heap& thin() {
  static const Heap heap{
      "thin", "thin heap (14 Pa)", 14.0, {{45.0, 6.0}, {15.0, 5.0}, {4.526, 5.0}, {0.7, 10.0}}};
  return heap;
}

constexpr double small_cutoff = 0.01;  // [1/s]; the flow's own rates are above 0.1 1/s

void add_heap(CaseRun& run, const Heap& heap, const std::vector<double>& spacings,
              const std::vector<const Outcome*>& outcomes) {
  const Material m = slumps::material_of({&heap, small_cutoff, 0.0});
  const Arrested thin_layer(m, 0), next(m, 1);
  const std::string key = heap.key;
  run.add({.key = key + "_aspect",
           .what = fmt::format("{}: depth at the wall over length, thin layer", heap.name),
           .value = thin_layer.depth_at_wall() / thin_layer.position(0.0)});
  run.add({.key = key + "_theory",
           .what = fmt::format("{}: run-out of thin-layer theory", heap.name),
           .value = thin_layer.front(),
           .unit = "m"});
  run.add({.key = key + "_theory_error",
           .what = fmt::format("{}: the theory's next order minus thin layer, run-out", heap.name),
           .value = 100.0 * (next.front_at(thin_layer) / thin_layer.front() - 1.0),
           .unit = "%"});
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    const double mm = 1e3 * spacings[k], front = outcomes[k]->front.back();
    const bool finest = k + 1 == spacings.size();
    const auto add = [&](const char* name, const char* words, double value, bool limited,
                         const char* explanation) {
      Measure measure;
      measure.key = without_dots(fmt::format("{}_{}_{:.3g}", key, name, mm));
      measure.what = fmt::format("{}: {}, {:.3g} mm", heap.name, words, mm);
      measure.value = value;
      measure.unit = fmt::format("%");
      if (limited) {
        measure.lower = -5.0;
        measure.upper = 5.0;
        measure.reason = "a heap's length follows from volume and yield stress to the power 1/3";
        measure.explanation = fmt::format("{}", explanation);
      }
      run.add(measure);
    };
    add("runout", "run-out against thin-layer theory", 100.0 * (front / thin_layer.front() - 1.0),
        finest,
        heap.yield_stress > 50.0
            ? "the heap is too thick for the theory; its next order is shorter by the value in the "
              "row above"
            : "the theory itself is long by 2 %; the rest is the front, a layer "
              "of one or two particles that stops early, and shrinks with "
              "the spacing");
    add("next", "run-out against the theory's next order",
        100.0 * (front / next.front_at(thin_layer) - 1.0), finest, "");
    run.add({.key = without_dots(fmt::format("{}_profile_{:.3g}", key, mm)),
             .what = fmt::format("{}: profile against the next order, rms of depth over depth at "
                                 "the wall, {:.3g} mm",
                                 heap.name, mm),
             .value = slumps::profile_error(*outcomes[k], next),
             .unit = "%",
             .upper = finest ? std::optional(5.0) : std::nullopt,
             .reason = finest ? "as for the run-out, of which the profile is the sum" : "",
             .explanation =
                 finest ? "the heap is a few particles deep; it falls with the spacing" : ""});
  }
  const Outcome& finest = *outcomes.back();
  run.add({.key = key + "_inertia",
           .what = fmt::format("{}: largest rho u2/2 over the yield stress after the release",
                               heap.name),
           .value = finest.inertia});
  run.add({.key = key + "_creep",
           .what = fmt::format("{}: speed of the front at the end", heap.name),
           .value = 1e3 * finest.front_speed,
           .unit = "mm/s"});
}

void draw_profile(CaseRun& run, const Heap& heap, const std::vector<double>& spacings,
                  const std::vector<const Outcome*>& outcomes) {
  const Material m = slumps::material_of({&heap, small_cutoff, 0.0});
  const Arrested thin_layer(m, 0), next(m, 1);
  reports::LinePlot plot;
  plot.title = fmt::format("Arrested slump, {}", heap.name);
  plot.x_label = "distance from the wall [m]";
  plot.y_label = "depth [mm]";
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    reports::PlotSeries s{fmt::format("{:.3g} mm", 1e3 * spacings[k]),
                          {},
                          {},
                          reports::SeriesStyle::line_and_markers,
                          static_cast<int>(k + 2)};
    for (std::size_t b = 0; b < outcomes[k]->x.size(); ++b) {
      if (outcomes[k]->depth[b] <= 0.0) break;
      s.x.push_back(outcomes[k]->x[b]);
      s.y.push_back(1e3 * outcomes[k]->depth[b]);
    }
    plot.series.push_back(s);
  }
  const auto line = [](const Arrested& theory, const char* name, reports::SeriesStyle style,
                       int color) {
    reports::PlotSeries s{name, {}, {}, style, color};
    for (int k = 0; k <= 200; ++k) {
      const double h = theory.depth_at_wall() * (1.0 - k / 200.0);
      s.x.push_back(theory.position(h));
      s.y.push_back(1e3 * h);
    }
    return s;
  };
  plot.series.push_back(line(thin_layer, "thin layer", reports::SeriesStyle::dashed, 1));
  plot.series.push_back(line(next, "next order", reports::SeriesStyle::line, 0));
  plot.width_px = 900;
  plot.height_px = 460;
  draw_line_plot(run.figure(fmt::format("{}.png", heap.key)), plot);
}

void draw_creep(CaseRun& run, const std::vector<Slump>& list,
                const std::vector<const Outcome*>& outcomes) {
  reports::LinePlot plot;
  plot.title = fmt::format("Front of Table 1's heap for cut-offs of the shear rate, {:.3g} mm",
                           1e3 * list.front().spacing);
  plot.x_label = "time [s]";
  plot.y_label = "position of the front [m]";
  for (std::size_t k = 0; k < list.size(); ++k) {
    plot.series.push_back({fmt::format("{:.2g} 1/s", list[k].cutoff), outcomes[k]->time,
                           outcomes[k]->front, reports::SeriesStyle::line, static_cast<int>(k)});
  }
  plot.width_px = 900;
  plot.height_px = 440;
  draw_line_plot(run.figure("creep.png"), plot);
}

}  // namespace

void slump(CaseRun& run) {
  const std::vector<double> spacings =
      run.full() ? std::vector{0.01, 0.0075, 0.005} : std::vector{0.025, 0.0175};
  std::vector<Slump> list;
  for (auto s = spacings.rbegin(); s != spacings.rend(); ++s) {
    if (run.full()) list.push_back({&thin(), small_cutoff, *s});
    list.push_back({&table1(), small_cutoff, *s});
  }
  const std::vector<double> cutoffs =
      run.full() ? std::vector{0.05, 0.1, 0.2, 0.5} : std::vector{0.1};
  for (const double cutoff : cutoffs) list.push_back({&table1(), cutoff, spacings.front()});
  std::vector<double> cost;
  for (const Slump& s : list) cost.push_back(1e-5 / std::pow(s.spacing, 3.0));
  std::vector<Outcome> outcomes(list.size());
  run.side_by_side(
      list.size(), [&](std::size_t k) { outcomes[k] = slumps::computed(list[k], run); }, cost);
  const auto find = [&](const Heap& heap, double cutoff, double spacing) -> const Outcome& {
    std::size_t k = 0;
    while (list[k].heap != &heap || list[k].cutoff != cutoff || list[k].spacing != spacing) ++k;
    return outcomes[k];
  };
  std::vector<const Heap*> heaps{&table1()};
  if (run.full()) heaps.push_back(&thin());
  for (const Heap* heap : heaps) {
    std::vector<const Outcome*> of_heap;
    for (const double spacing : spacings) of_heap.push_back(&find(*heap, small_cutoff, spacing));
    add_heap(run, *heap, spacings, of_heap);
    draw_profile(run, *heap, spacings, of_heap);
  }
  std::vector<Slump> creeping{{&table1(), small_cutoff, spacings.front()}};
  for (const double cutoff : cutoffs) creeping.push_back({&table1(), cutoff, spacings.front()});
  std::vector<const Outcome*> creeps;
  const double scale = Arrested(Material{}, 0).depth_at_wall() / 3.0;
  for (const Slump& s : creeping) {
    creeps.push_back(&find(table1(), s.cutoff, s.spacing));
    const Outcome& o = *creeps.back();
    if (&s == &creeping.front()) continue;
    run.add({.key = without_dots(fmt::format("cutoff_{:.2g}", s.cutoff)),
             .what = fmt::format("Table 1: run-out with a cut-off of {:.2g} 1/s against one of "
                                 "{:.2g} 1/s, {:.3g} mm",
                                 s.cutoff, small_cutoff, 1e3 * s.spacing),
             .value = 100.0 * (o.front.back() / creeps.front()->front.back() - 1.0),
             .unit = "%"});
    run.add({.key = without_dots(fmt::format("creep_{:.2g}", s.cutoff)),
             .what = fmt::format("Table 1: speed that a cut-off of {:.2g} 1/s adds to the front at "
                                 "the end, over cut-off x h(0)/3",
                                 s.cutoff),
             .value = (o.front_speed - creeps.front()->front_speed) / (s.cutoff * scale),
             .lower = 0.0,
             .upper = 1.0,
             .reason = "mean speed of a layer of depth h(0) and viscosity tau_y/cut-off under the "
                       "yield stress: the fastest that creep can be"});
  }
  draw_creep(run, creeping, creeps);
  const Outcome& finest = find(table1(), small_cutoff, spacings.back());
  run.add({.key = "mass",
           .what = "change of the mass",
           .value = finest.mass_change,
           .upper = 1e-12,
           .reason = "particles keep their mass; the sum rounds"});
  run.add({.key = "momentum",
           .what = "momentum not explained by gravity and wall forces",
           .value = 100.0 * finest.momentum_error,
           .unit = "%",
           .upper = 1.0,
           .reason = "share of the impulse of gravity"});
  run.add({.key = "energy",
           .what = fmt::format("Table 1, {:.3g} mm: energy lost that viscosity does not explain",
                               1e3 * spacings.back()),
           .value = 100.0 * (1.0 - finest.dissipated / finest.energy_lost),
           .unit = "%",
           .lower = -10.0,
           .upper = 10.0,
           .reason = "density diffusion and shifting may take or give an amount that is small "
                     "beside the viscous dissipation, of first order in the spacing",
           .explanation = "it falls with the spacing, from a tenth at 17.5 mm to half of it at 5"});
  int inside = 0;
  for (const Outcome& o : outcomes) inside += o.inside;
  run.add({.key = "inside",
           .what = "particles inside walls",
           .value = static_cast<double>(inside),
           .upper = 0.0,
           .reason = "a wall is a wall"});
  ParticlePicture picture;
  const Outcome& pictured = find(table1(), small_cutoff, spacings[1]);
  picture.title = fmt::format("Table 1's heap, {:.3g} mm: speed", 1e3 * spacings[1]);
  picture.quantity = "speed [mm/s]";
  picture.low = 0.0;
  picture.high = 10.0;
  picture.spacing = spacings[1];
  picture.walls = pictured.walls;
  picture.window_from = {-0.01, -0.01};
  picture.window_to = {0.85, 0.16};
  picture.panels = pictured.panels;
  picture.columns = 1;
  picture.width_px = 800;
  draw(run, "particles.png", picture);
}

}  // namespace parapet::validation
