// Grid convergence of the metrics that designs are judged by: three particle spacings, means over
// jittered lattices, Richardson extrapolation and the grid convergence index (Roache 1994; least
// squares after Eca and Hoekstra 2014), which is what `parapet simulate --uncertainty` reports.
#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <vector>

#include "barrier_runs.hpp"
#include "cases.hpp"
#include "parapet/reports/line_plot.hpp"
#include "parapet/solver/uncertainty.hpp"

namespace parapet::validation {
namespace {

constexpr std::array<SingleBarrier, 6> rows{{{"wd2", "H10-WD2, bare 100 mm", 0.1, bare},
                                             {"d0", "H10-D0", 0.1, 0.0},
                                             {"d30", "H10-D30", 0.1, 30.0},
                                             {"d45", "H10-D45", 0.1, 45.0},
                                             {"d60", "H10-D60", 0.1, 60.0},
                                             {"h18", "bare 180 mm", 0.18, bare}}};

solver::Result refined(const SingleBarrier& barrier, double spacing, const CaseRun& run) {
  solver::Numerics numerics;
  numerics.spacing = spacing;
  solver::Result result =
      simulate_with_uncertainty(scene_of(barrier), numerics, {}, {}, [&](double) {
        run.check_cancelled();
        return true;
      });
  if (result.status != solver::Status::ok) throw std::runtime_error(result.reason);
  return result;
}

void add_row(CaseRun& run, const SingleBarrier& barrier, const JudgedMetric& judged,
             const solver::Result& result) {
  const solver::Metric* metric = result.find_metric(judged.key);
  const std::string key = fmt::format("{}_{}", barrier.key, judged.key);
  const std::string of = fmt::format("{}: {}", barrier.name, judged.name);
  const double spacing = metric->uncertainty ? metric->uncertainty->level_spacing.front() : 0.0;
  if (!metric->uncertainty) {
    run.add({.key = key, .what = of + ": a run has no value", .value = 0.0});
    return;
  }
  const solver::MetricUncertainty& u = *metric->uncertainty;
  run.add({.key = key,
           .what = fmt::format("{} at {:.1f} mm", of, 1e3 * spacing),
           .value = judged.scale * *metric->value,
           .unit = judged.unit});
  run.add(
      {.key = key + "_gci",
       .what = fmt::format("{}, grid convergence index ({})", of,
                           u.order_observed ? fmt::format("order {:.1f}", u.order)
                                            : "not in the asymptotic range, factor of safety 3"),
       .value = judged.scale * u.discretisation,
       .unit = judged.unit});
  run.add({.key = key + "_limit",
           .what = of + ", extrapolated to fine spacings",
           .value = judged.scale * u.extrapolated,
           .unit = judged.unit});
  run.add({.key = key + "_scatter",
           .what = of + ", standard deviation between jittered lattices (pooled)",
           .value = judged.scale * u.scatter,
           .unit = judged.unit});
  run.add({.key = key + "_expanded",
           .what = of + ", expanded uncertainty (95 %)",
           .value = judged.scale * u.expanded,
           .unit = judged.unit});
}

}  // namespace

void grid_convergence(CaseRun& run) {
  const double spacing = run.full() ? 0.005 : 0.0125;
  const std::size_t n_rows = run.full() ? rows.size() : 1;
  std::vector<solver::Result> results(n_rows);
  run.side_by_side(
      n_rows, [&](std::size_t k) { results[k] = refined(rows[k], spacing, run); },
      std::vector<double>(n_rows, run.full() ? 45.0 : 3.0));
  for (const JudgedMetric& judged : judged_metrics) {
    reports::LinePlot plot;
    plot.title = fmt::format("{} against the particle spacing", judged.name);
    plot.x_label = "particle spacing [mm]";
    plot.y_label = fmt::format("{} [{}], mean", judged.name, *judged.unit ? judged.unit : "-");
    for (std::size_t row = 0; row < n_rows; ++row) {
      add_row(run, rows[row], judged, results[row]);
      const auto& u = results[row].find_metric(judged.key)->uncertainty;
      if (!u) continue;
      reports::PlotSeries series{
          rows[row].name, {}, {}, reports::SeriesStyle::line_and_markers, {}};
      for (std::size_t level = 0; level < u->level_mean.size(); ++level) {
        series.x.push_back(1e3 * u->level_spacing[level]);
        series.y.push_back(judged.scale * u->level_mean[level]);
      }
      plot.series.push_back(series);
    }
    plot.width_px = 800;
    plot.height_px = 480;
    if (!plot.series.empty()) draw_line_plot(run.figure(std::string(judged.key) + ".png"), plot);
  }
}

}  // namespace parapet::validation
