// The metrics that designs are judged by over closely spaced designs: they must change smoothly, up
// to the scatter that equal runs have (the middle design with jittered lattices).
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "barrier_runs.hpp"
#include "cases.hpp"
#include "parapet/reports/line_plot.hpp"

namespace parapet::validation {
namespace {

struct Sweep {
  const char* key;
  const char* name;
  const char* x_label;
  std::vector<SingleBarrier> designs;
  std::vector<double> x;
  std::vector<solver::Result> results;
  std::vector<solver::Result> repeats;  // of the middle design
};

// A run that fails is a recorded result: all its metrics are absent.
solver::Result recorded(const SingleBarrier& design, const solver::Numerics& numerics,
                        const CaseRun& run) {
  try {
    return simulated(scene_of(design), numerics, run);
  } catch (const std::runtime_error& error) {
    solver::Result failed;
    failed.status = solver::Status::failed;
    failed.reason = error.what();
    return failed;
  }
}

// A cubic has four coefficients; fewer values than this say nothing of what is left beside it.
constexpr std::size_t least_values = 8;

// Standard deviation of a metric between the repeats.
double scatter_of(const Sweep& sweep, const JudgedMetric& judged) {
  const auto s = spread(sweep.repeats, judged);
  return s ? s->deviation : std::numeric_limits<double>::quiet_NaN();
}

// Residuals of a cubic fit, and their standard deviation.
struct Residuals {
  std::vector<double> fit;
  double deviation = 0.0, largest = 0.0, largest_step = 0.0;
};

Residuals cubic_residuals(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const double x0 = x.front(), span = x.back() - x.front();
  Eigen::MatrixXd a(n, 4);
  Eigen::VectorXd b(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double s = 2.0 * (x[static_cast<std::size_t>(k)] - x0) / span - 1.0;
    a.row(k) << 1.0, s, s * s, s * s * s;
    b(k) = y[static_cast<std::size_t>(k)];
  }
  const Eigen::VectorXd fit = a * a.colPivHouseholderQr().solve(b);
  const Eigen::VectorXd off = b - fit;
  Residuals r;
  r.fit.assign(fit.data(), fit.data() + n);
  r.deviation = std::sqrt(off.squaredNorm() / static_cast<double>(n - 4));
  r.largest = off.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 1; k < n; ++k) {
    r.largest_step = std::max(r.largest_step, std::abs(off(k) - off(k - 1)));
  }
  return r;
}

void judge(CaseRun& run, const Sweep& sweep, const JudgedMetric& judged) {
  std::vector<double> x, y;
  for (std::size_t k = 0; k < sweep.x.size(); ++k) {
    const double value = judged.scale * metric(sweep.results[k], judged.key);
    if (!std::isfinite(value)) continue;  // nothing overflows
    x.push_back(sweep.x[k]);
    y.push_back(value);
  }
  if (x.size() < least_values) return;  // too coarse for this metric, as in the quick suite
  const Residuals r = cubic_residuals(x, y);
  const std::string key = fmt::format("{}_{}", sweep.key, judged.key);
  const std::string of = fmt::format("{}: {}", sweep.name, judged.name);
  run.add({.key = key + "_scatter",
           .what = of + ", standard deviation about a cubic",
           .value = r.deviation,
           .unit = judged.unit});
  const double scatter = scatter_of(sweep, judged);
  run.add({.key = key + "_repeats",
           .what = fmt::format("{}, standard deviation between {} equal runs of the middle design",
                               of, sweep.repeats.size()),
           .value = scatter,
           .unit = judged.unit});
  run.add({.key = key + "_ratio",
           .what = of + ", first over second",
           .value = r.deviation / scatter,
           .upper = 2.0,
           .reason = "the repeats give the scatter within a quarter; it differs between designs, "
                     "and a cubic may not fit",
           .explanation = "the scatter of the middle design is not that of all: see the plot"});
  run.add(
      {.key = key + "_step",
       .what = of + ", largest step between neighbours beyond the cubic, in standard deviations",
       .value = r.largest_step / r.deviation,
       .upper = 5.0,
       .reason = "the largest of some 50 differences of independent normal scatter stays below "
                 "5 in 98 of 100 sweeps"});
  reports::LinePlot plot;
  plot.title = of;
  plot.x_label = sweep.x_label;
  plot.y_label = fmt::format("{} [{}]", judged.name, *judged.unit ? judged.unit : "-");
  reports::PlotBand band{"two standard deviations about the cubic", x, {}, {}, 1};
  for (const double fit : r.fit) {
    band.lower.push_back(fit - 2.0 * r.deviation);
    band.upper.push_back(fit + 2.0 * r.deviation);
  }
  plot.bands = {band};
  plot.series = {{"simulated", x, y, reports::SeriesStyle::line_and_markers, 0}};
  plot.width_px = 800;
  plot.height_px = 480;
  draw_line_plot(run.figure(key + ".png"), plot);
}

}  // namespace

void smoothness(CaseRun& run) {
  const int n_angles = run.full() ? 61 : 13, n_heights = run.full() ? 41 : 9;
  Sweep angles{"angle", "deflector angle", "deflector angle [deg]", {}, {}, {}, {}};
  Sweep heights{"height", "height of a bare barrier", "height [mm]", {}, {}, {}, {}};
  const std::size_t n_repeats = run.full() ? 12 : 4;
  for (int k = 0; k < n_angles; ++k) {
    angles.x.push_back(60.0 * k / (n_angles - 1));
    angles.designs.push_back({"", "", 0.1, angles.x.back()});
  }
  for (int k = 0; k < n_heights; ++k) {
    heights.x.push_back(60.0 + 80.0 * k / (n_heights - 1));
    heights.designs.push_back({"", "", 1e-3 * heights.x.back(), bare});
  }
  std::vector<std::pair<Sweep*, std::size_t>> tasks;
  for (Sweep* sweep : {&angles, &heights}) {
    sweep->results.resize(sweep->x.size());
    sweep->repeats.resize(n_repeats);
    for (std::size_t k = 0; k < sweep->x.size() + n_repeats; ++k) tasks.emplace_back(sweep, k);
  }
  solver::Numerics numerics;
  numerics.spacing = run.full() ? 0.01 : 0.02;
  run.side_by_side(
      tasks.size(),
      [&](std::size_t t) {
        const auto [sweep, k] = tasks[t];
        if (k < sweep->x.size()) {
          sweep->results[k] = recorded(sweep->designs[k], numerics, run);
          return;
        }
        solver::Numerics jittered = numerics;
        jittered.lattice_jitter = 0.01;
        jittered.lattice_seed = static_cast<unsigned>(k);
        sweep->repeats[k - sweep->x.size()] =
            recorded(sweep->designs[sweep->x.size() / 2], jittered, run);
      },
      std::vector<double>(tasks.size(), run.full() ? 3.0 : 0.2));
  int failed = 0;
  for (const Sweep* sweep : {&angles, &heights}) {
    for (const auto* results : {&sweep->results, &sweep->repeats}) {
      for (const solver::Result& r : *results) failed += r.status != solver::Status::ok;
    }
  }
  run.add({.key = "failed",
           .what = fmt::format("runs that failed, of {}", tasks.size()),
           .value = static_cast<double>(failed),
           .upper = 0.0,
           .reason = "every design can be computed",
           .explanation = "single particles run away where the flow is one or two particles deep"});
  for (const Sweep* sweep : {&angles, &heights}) {
    for (const JudgedMetric& judged : judged_metrics) judge(run, *sweep, judged);
  }
}

}  // namespace parapet::validation
