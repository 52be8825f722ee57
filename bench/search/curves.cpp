#include <algorithm>
#include <cmath>
#include <set>

#include "parapet/reports/line_plot.hpp"
#include "tables_text.hpp"

namespace parapet::bench::search {
namespace {

// Curves of methods agree in colour over all figures.
int color_of(const std::string& family) {
  const std::vector<std::string> order = {"bayesian",     "nlopt",  "pagmo_nsga2",    "optuna_tpe",
                                          "optuna_nsga2", "random", "bayesian_levels"};
  return static_cast<int>(std::find(order.begin(), order.end(), family) - order.begin());
}

std::vector<double> counted(std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t k = 0; k < n; ++k) x[k] = static_cast<double>(k + 1);
  return x;
}

// The share at given times: the last step that was finished by then.
double share_at(const Curve& curve, double seconds) {
  const auto after = std::upper_bound(curve.seconds.begin(), curve.seconds.end(), seconds + 1e-9);
  const auto steps = after - curve.seconds.begin();
  return steps == 0 ? 0.0 : curve.share[static_cast<std::size_t>(steps - 1)];
}

reports::PlotSeries over_seconds(const MethodScore& score, double limit) {
  reports::PlotSeries series{
      score.label, {}, {}, reports::SeriesStyle::line, color_of(score.family)};
  for (int k = 0; k <= 200; ++k) {
    const double seconds = limit * k / 200.0;
    std::vector<double> shares;
    for (const Curve& curve : score.curves) shares.push_back(share_at(curve, seconds));
    series.x.push_back(seconds);
    series.y.push_back(quantile(shares, 0.5));
  }
  return series;
}

reports::LinePlot plot_of(const Comparison& comparison, const std::string& x_label, double limit) {
  reports::LinePlot plot;
  plot.title = comparison.problem.title;
  plot.x_label = x_label;
  plot.y_label = "share of the hypervolume, median";
  plot.x_limits = {0.0, limit};
  plot.y_limits = {0.0, 1.02};
  return plot;
}

void draw(const reports::LinePlot& plot, const std::filesystem::path& folder,
          const std::string& name, std::vector<std::string>& files) {
  for (const char* ending : {".png", ".svg"}) {
    draw_line_plot(folder / (name + ending), plot);
    files.push_back(name + ending);
  }
}

}  // namespace

std::vector<std::string> draw_curves(const Comparison& comparison,
                                     const std::filesystem::path& folder) {
  constexpr double shown = 300.0;  // evaluations; beyond, the curves are flat
  std::vector<std::string> files;
  reports::LinePlot plot = plot_of(comparison, "evaluations", shown);
  std::set<std::string> drawn;
  for (const MethodScore& s : comparison.scores) {  // best first, so the first of each family
    if (s.method == "bayesian_levels" || !drawn.insert(s.family).second) continue;
    const std::vector<double> x = counted(s.median_share.size());
    plot.series.push_back(
        {s.label, x, s.median_share, reports::SeriesStyle::line, color_of(s.family)});
    if (s.family == "bayesian") {
      plot.bands.push_back({"its quartiles", x, s.lower_share, s.upper_share, color_of(s.family)});
    }
  }
  draw(plot, folder, comparison.problem.name, files);
  const MethodScore* one = comparison.find("bayesian");
  const MethodScore* all = comparison.find("bayesian_levels");
  if (one == nullptr || all == nullptr) return files;
  const double limit = one->budget * comparison.problem.level_seconds.front();
  reports::LinePlot seconds = plot_of(comparison, "simulated seconds", limit);
  for (const MethodScore* s : {one, all}) seconds.series.push_back(over_seconds(*s, limit));
  draw(seconds, folder, comparison.problem.name + "_seconds", files);
  return files;
}

}  // namespace parapet::bench::search
