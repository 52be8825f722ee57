// Grid convergence index of the metrics that designs are judged by (Roache 1994; procedure of Celik
// et al. 2008, J. Fluids Eng. 130:078001): three spacings, Richardson extrapolation, observed
// order.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "barrier_runs.hpp"
#include "cases.hpp"
#include "parapet/reports/line_plot.hpp"

namespace parapet::validation {
namespace {

constexpr std::array<SingleBarrier, 6> rows{{{"wd2", "H10-WD2, bare 100 mm", 0.1, bare},
                                             {"d0", "H10-D0", 0.1, 0.0},
                                             {"d30", "H10-D30", 0.1, 30.0},
                                             {"d45", "H10-D45", 0.1, 45.0},
                                             {"d60", "H10-D60", 0.1, 60.0},
                                             {"h18", "bare 180 mm", 0.18, bare}}};

struct Convergence {
  double order = 0.0;       // observed, or the one assumed
  bool asymptotic = false;  // monotone with an order between 0.5 and 3
  double gci = 0.0;         // of the finest value, in its unit
};

// coarse, middle, fine values at spacings h[0] > h[1] > h[2].
Convergence grid_convergence_index(const std::array<double, 3>& h, const std::array<double, 3>& f) {
  const double r21 = h[1] / h[2], r32 = h[0] / h[1];
  const double e21 = f[1] - f[2], e32 = f[0] - f[1];
  Convergence c;
  c.order = 1.0;  // assumed where none can be observed: the lower of what the flow tests show
  if (e21 != 0.0 && e32 / e21 > 0.0) {
    double p = 1.0;
    for (int k = 0; k < 100; ++k) {  // Eq. 3 of Celik et al. as a fixed point
      const double q = std::log((std::pow(r21, p) - 1.0) / (std::pow(r32, p) - 1.0));
      p = std::clamp(std::abs(std::log(std::abs(e32 / e21)) + q) / std::log(r21), 0.05, 20.0);
    }
    c.asymptotic = p >= 0.5 && p <= 3.0;
    c.order = c.asymptotic ? p : (p > 3.0 ? 2.0 : 1.0);
  }
  const double worst = c.asymptotic ? std::abs(e21) : std::max(std::abs(e21), std::abs(e32));
  c.gci = (c.asymptotic ? 1.25 : 3.0) * worst / (std::pow(r21, c.order) - 1.0);
  return c;
}

}  // namespace

void grid_convergence(CaseRun& run) {
  const std::array<double, 3> spacings =
      run.full() ? std::array{0.01, 1.0 / 140.0, 0.005} : std::array{0.03, 0.025, 0.02};
  const std::array<double, 3> costs =
      run.full() ? std::array{3.0, 8.0, 25.0} : std::array{0.1, 0.2, 0.4};
  const std::size_t n_rows = run.full() ? rows.size() : 2;
  std::vector<std::array<solver::Result, 3>> results(n_rows);
  std::vector<double> cost_list;
  for (std::size_t k = 0; k < 3 * n_rows; ++k) cost_list.push_back(costs[2 - k / n_rows]);
  run.side_by_side(
      3 * n_rows,
      [&](std::size_t k) {
        solver::Numerics numerics;
        const std::size_t level = 2 - k / n_rows;  // the dearest first
        numerics.spacing = spacings[level];
        results[k % n_rows][level] = simulated(scene_of(rows[k % n_rows]), numerics, run);
      },
      cost_list);
  for (const JudgedMetric& judged : judged_metrics) {
    reports::LinePlot plot;
    plot.title = fmt::format("{} against the particle spacing", judged.name);
    plot.x_label = "particle spacing [mm]";
    plot.y_label = fmt::format("{} [{}]", judged.name, *judged.unit ? judged.unit : "-");
    for (std::size_t row = 0; row < n_rows; ++row) {
      std::array<double, 3> values{};
      reports::PlotSeries series{
          rows[row].name, {}, {}, reports::SeriesStyle::line_and_markers, {}};
      for (std::size_t level = 0; level < 3; ++level) {
        values[level] = judged.scale * metric(results[row][level], judged.key);
        series.x.push_back(1e3 * spacings[level]);
        series.y.push_back(values[level]);
        run.add(
            {.key = fmt::format("{}_{}_{:.0f}um", rows[row].key, judged.key, 1e6 * spacings[level]),
             .what = fmt::format("{}: {} at {:.2f} mm", rows[row].name, judged.name,
                                 1e3 * spacings[level]),
             .value = values[level],
             .unit = judged.unit});
      }
      const Convergence c = grid_convergence_index(spacings, values);
      run.add({.key = fmt::format("{}_{}_gci", rows[row].key, judged.key),
               .what = fmt::format("{}: {}, GCI of the finest ({})", rows[row].name, judged.name,
                                   c.asymptotic ? fmt::format("order {:.1f}", c.order)
                                                : "not in the asymptotic range"),
               .value = c.gci,
               .unit = judged.unit});
      plot.series.push_back(series);
    }
    plot.width_px = 800;
    plot.height_px = 480;
    draw_line_plot(run.figure(std::string(judged.key) + ".png"), plot);
  }
}

}  // namespace parapet::validation
