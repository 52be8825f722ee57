// How far the metrics move between runs that no engineer would tell apart: the initial lattice
// jittered by 1 % of the spacing, or the yield stress changed by a millionth. The flow is chaotic
// after the impact; this scatter is what a search over designs must live with.
#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "barrier_runs.hpp"
#include "cases.hpp"
#include "parapet/reports/line_plot.hpp"

namespace parapet::validation {
namespace {

struct Group {
  std::size_t design;
  double spacing;  // [m]
  bool jittered;   // else the yield stress changes
  std::size_t runs;
  double cost;  // [s]
  std::vector<solver::Result> results;
};

solver::Result repeat(const Group& group, std::size_t index, const CaseRun& run) {
  solver::Scene scene = scene_of(three_barriers[group.design]);
  solver::Numerics numerics;
  numerics.spacing = group.spacing;
  if (group.jittered) {
    numerics.lattice_jitter = 0.01;
    numerics.lattice_seed = static_cast<unsigned>(index + 1);
  } else {
    scene.material.yield_stress *= 1.0 + 1e-6 * static_cast<double>(index);
  }
  return simulated(scene, numerics, run);
}

std::vector<Group> groups(bool full) {
  std::vector<Group> list;
  if (!full) return {{2, 0.02, true, 4, 1.0, {}}};
  list.push_back({0, 0.005, true, 6, 25.0, {}});
  list.push_back({2, 0.005, true, 6, 25.0, {}});
  for (std::size_t design = 0; design < std::size(three_barriers); ++design) {
    list.push_back({design, 0.01, true, 12, 3.0, {}});
  }
  list.push_back({2, 0.01, false, 8, 3.0, {}});
  return list;
}

}  // namespace

void noise(CaseRun& run) {
  std::vector<Group> list = groups(run.full());
  std::vector<std::pair<std::size_t, std::size_t>> tasks;
  std::vector<double> costs;
  for (std::size_t g = 0; g < list.size(); ++g) {
    list[g].results.resize(list[g].runs);
    for (std::size_t k = 0; k < list[g].runs; ++k) {
      tasks.emplace_back(g, k);
      costs.push_back(list[g].cost);
    }
  }
  run.side_by_side(
      tasks.size(),
      [&](std::size_t t) {
        const auto [g, k] = tasks[t];
        list[g].results[k] = repeat(list[g], k, run);
      },
      costs);
  for (const Group& group : list) {
    const char* how = group.jittered ? "lattice jittered" : "yield stress + 1e-6";
    for (const JudgedMetric& judged : judged_metrics) {
      const auto s = spread(group.results, judged);
      if (!s) continue;
      const std::string key =
          fmt::format("{}_{}_{:.0f}mm_{}", three_barriers[group.design].key,
                      group.jittered ? "jitter" : "nudge", 1e3 * group.spacing, judged.key);
      const std::string of = fmt::format("{}, {:.0f} mm, {}: {}", three_barriers[group.design].name,
                                         1e3 * group.spacing, how, judged.name);
      run.add({.key = key,
               .what = of + ", standard deviation",
               .value = s->deviation,
               .unit = judged.unit});
      run.add({.key = key + "_mean",
               .what = of + ", mean of " + std::to_string(s->runs),
               .value = s->mean,
               .unit = judged.unit});
    }
  }
  reports::LinePlot plot;
  plot.title = "Retention of runs that no engineer would tell apart";
  plot.x_label = "run";
  plot.y_label = "retention efficiency [-]";
  for (const Group& group : list) {
    reports::PlotSeries series;
    series.label = fmt::format("{}, {:.0f} mm, {}", three_barriers[group.design].name,
                               1e3 * group.spacing, group.jittered ? "jitter" : "nudge");
    series.style = reports::SeriesStyle::line_and_markers;
    for (std::size_t k = 0; k < group.runs; ++k) {
      series.x.push_back(static_cast<double>(k + 1));
      series.y.push_back(metric(group.results[k], "retention_efficiency"));
    }
    plot.series.push_back(series);
  }
  plot.width_px = 800;
  plot.height_px = 480;
  draw_line_plot(run.figure("retention.png"), plot);
}

}  // namespace parapet::validation
