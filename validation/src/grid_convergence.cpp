// Grid convergence of the metrics that designs are judged by: four particle spacings, means over
// jittered lattices, Richardson extrapolation and the grid convergence index (Roache 1994; least
// squares after Eca and Hoekstra 2014), as `parapet simulate --uncertainty` reports; and which
// spacing a metric needs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
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
  solver::UncertaintyPlan plan;
  if (run.full()) plan.levels = {{1.0, 2}, {std::sqrt(2.0), 4}, {2.0, 6}, {std::sqrt(8.0), 8}};
  solver::Result result =
      simulate_with_uncertainty(scene_of(barrier), numerics, {}, plan, [&](double) {
        run.check_cancelled();
        return true;
      });
  if (result.status != solver::Status::ok) throw std::runtime_error(result.reason);
  return result;
}

// The parts of the grid convergence index: what falls with the spacing, and the scatter of the fit
// about the means.
struct GridParts {
  double falling, fixed, order;
};

GridParts parts_of(const solver::MetricUncertainty& u) {
  const solver::DiscretisationError fit =
      solver::discretisation_error(u.level_spacing, u.level_mean);
  const double rest =
      fit.deviation + std::abs(u.level_mean.front() - u.extrapolated - fit.coefficient);
  return {std::max(0.0, u.discretisation - rest), rest, u.order};
}

// Expanded uncertainty of the mean of so many lattices at a spacing, over its value by the fit.
double relative_uncertainty(const solver::MetricUncertainty& u, double spacing, int lattices) {
  const GridParts parts = parts_of(u);
  const double coarser = std::pow(spacing / u.level_spacing.front(), parts.order);
  const double value = u.extrapolated + coarser * (u.level_mean.front() - u.extrapolated);
  const double grid = parts.falling * coarser + parts.fixed;
  return std::hypot(grid, 2.0 * u.scatter / std::sqrt(lattices)) / std::abs(value);
}

// The coarsest spacing at which it is no more than a share, at most the coarsest that was tried
// [m].
double spacing_for(const solver::MetricUncertainty& u, double share, int lattices) {
  double fine = 0.0, coarse = u.level_spacing.back();
  if (relative_uncertainty(u, coarse, lattices) <= share) return coarse;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (fine + coarse);
    (relative_uncertainty(u, middle, lattices) <= share ? fine : coarse) = middle;
  }
  return fine;
}

// How far the design load is known, of one run and of the mean of four lattices.
void add_load_uncertainty(CaseRun& run, const SingleBarrier& barrier,
                          const solver::Result& result) {
  constexpr double wanted = 0.15;
  const auto& u = result.find_metric("barrier_1_design_force_n_per_m")->uncertainty;
  if (!u) return;
  for (const int lattices : {1, 4}) {
    const std::string of = fmt::format("{}: design force, {}", barrier.name,
                                       lattices == 1 ? "one run" : "mean of four lattices");
    const auto key = [&](const char* name) {
      return fmt::format("{}_load_{}_{}", barrier.key, name, lattices);
    };
    Measure known{.key = key("known"),
                  .what = fmt::format("{}: expanded uncertainty (95 %) at {:.1f} mm", of,
                                      1e3 * u->level_spacing.front()),
                  .value = 100.0 * relative_uncertainty(*u, u->level_spacing.front(), lattices),
                  .unit = "%"};
    if (run.full()) {
      known.upper = 100.0 * wanted;
      known.reason = "wanted of a load to design with";
      known.explanation =
          "nearly all of it is the grid's part: three times the distance to the "
          "limit, as long as no order of convergence is observed";
    }
    run.add(std::move(known));
    run.add({.key = key("at_5mm"),
             .what = of + ": the same at 5 mm",
             .value = 100.0 * relative_uncertainty(*u, 0.005, lattices),
             .unit = "%"});
    run.add({.key = key("needs_15"),
             .what = of + ": spacing at which it is 15 %",
             .value = 1e3 * spacing_for(*u, wanted, lattices),
             .unit = "mm"});
  }
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

// The spacing at which the fit is a share of its limit off; none where values scatter by more than
// that share about the fit, or the limit is 0 [m].
std::optional<double> needed_spacing(const solver::MetricUncertainty& u, double share) {
  const solver::DiscretisationError fit =
      solver::discretisation_error(u.level_spacing, u.level_mean);
  const double allowed = share * std::abs(fit.extrapolated);
  if (!(allowed > fit.deviation)) return std::nullopt;
  if (fit.coefficient == 0.0) return u.level_spacing.back();
  const double ratio = std::pow(allowed / std::abs(fit.coefficient), 1.0 / fit.order);
  return std::min(u.level_spacing.front() * ratio, u.level_spacing.back());
}

// For every metric the median over the rows of the spacing that it needs.
void add_needed_spacings(CaseRun& run, const std::vector<solver::Result>& results) {
  for (const solver::Metric& metric : results.front().metrics) {
    for (const int percent : {5, 2}) {
      std::vector<double> needed;
      std::size_t known = 0;
      for (const solver::Result& result : results) {
        const auto& u = result.find_metric(metric.key)->uncertainty;
        if (!u) continue;
        ++known;
        if (const auto h = needed_spacing(*u, 0.01 * percent)) needed.push_back(*h);
      }
      if (known == 0) continue;
      std::ranges::sort(needed);
      // rows that scatter too much count as needing more than was tried
      const std::size_t middle = known / 2, lost = known - needed.size();
      run.add({.key = fmt::format("needs_{}_{}", percent, metric.key),
               .what = fmt::format("{}: spacing for {} % of its limit, median of {} rows ({} "
                                   "scatter by more)",
                                   metric.key, percent, known, lost),
               .value = middle < lost ? 0.0 : 1e3 * needed[middle - lost],
               .unit = "mm"});
    }
  }
}

}  // namespace

void grid_convergence(CaseRun& run) {
  const double spacing = run.full() ? 0.01 / std::sqrt(8.0) : 0.0125;
  const std::size_t n_rows = run.full() ? rows.size() : 1;
  std::vector<solver::Result> results(n_rows);
  run.side_by_side(
      n_rows, [&](std::size_t k) { results[k] = refined(rows[k], spacing, run); },
      std::vector<double>(n_rows, run.full() ? 80.0 : 3.0));
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
  for (std::size_t row = 0; row < n_rows; ++row) add_load_uncertainty(run, rows[row], results[row]);
  add_needed_spacings(run, results);
}

}  // namespace parapet::validation
