#include "parapet/reports/study_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "design_text.hpp"
#include "parapet/reports/line_plot.hpp"

namespace parapet::reports {
namespace {

using Front = std::vector<FrontDesign>;

constexpr double gap = std::numeric_limits<double>::quiet_NaN();  // interrupts a line

/// The surrogate's estimate; the value itself of a formula, which is known exactly.
std::optional<double> middle(const ObjectiveEstimate& objective) {
  return objective.terms.expression.empty() ? objective.estimate.median : objective.value;
}

/// Bars from the lower to the upper end of the surrogate's interval, across the estimate.
PlotSeries interval_bars(const Front& front, std::size_t a, std::size_t b) {
  PlotSeries bars{.label = "surrogate, 95 % interval", .x = {}, .y = {}, .color = 5};
  const auto add = [&](double x0, double y0, double x1, double y1) {
    bars.x.insert(bars.x.end(), {x0, x1, gap});
    bars.y.insert(bars.y.end(), {y0, y1, gap});
  };
  for (const FrontDesign& design : front) {
    const ObjectiveEstimate &one = design.objectives[a], &other = design.objectives[b];
    const auto x = middle(one), y = middle(other);
    if (!x || !y) continue;
    const auto &x0 = one.estimate.lower_95, &x1 = one.estimate.upper_95;
    const auto &y0 = other.estimate.lower_95, &y1 = other.estimate.upper_95;
    if (x0 && x1) add(*x0, *y, *x1, *y);
    if (y0 && y1) add(*x, *y0, *x, *y1);
  }
  return bars;
}

PlotSeries points(const Front& front, std::size_t a, std::size_t b, const std::string& only_id) {
  PlotSeries series;
  series.style = SeriesStyle::markers;
  for (const FrontDesign& design : front) {
    if (!only_id.empty() && design.id != only_id) continue;
    series.x.push_back(design.objectives[a].value.value_or(gap));
    series.y.push_back(design.objectives[b].value.value_or(gap));
  }
  return series;
}

/// What the front dominates is bounded by steps; with more than two objectives a projection has
/// none.
PlotSeries steps(const Front& front) {
  PlotSeries line{.label = "", .x = {}, .y = {}, .style = SeriesStyle::dashed, .color = 0};
  std::vector<std::pair<double, double>> at;
  for (const FrontDesign& design : front) {
    const auto &x = design.objectives[0].value, &y = design.objectives[1].value;
    if (x && y) at.emplace_back(*x, *y);
  }
  std::ranges::sort(at);
  const bool more_is_better = front.front().objectives[0].terms.goal == designs::Goal::maximize;
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (k > 0) {  // the corner that is worse in both
      line.x.push_back(more_is_better ? at[k - 1].first : at[k].first);
      line.y.push_back(more_is_better ? at[k].second : at[k - 1].second);
    }
    line.x.push_back(at[k].first);
    line.y.push_back(at[k].second);
  }
  return line;
}

std::string axis_label(const ObjectiveTerms& objective) {
  const char* better =
      objective.goal == designs::Goal::maximize ? "more is better" : "less is better";
  return fmt::format("{} ({})", objective_label(objective), better);
}

void draw_front(const std::filesystem::path& file, const Recommendation& advice, std::size_t a,
                std::size_t b) {
  const Front& front = advice.front;
  const std::vector<ObjectiveTerms>& objectives = advice.study.objectives;
  LinePlot plot;
  plot.title = advice.study.spec.name + ": the front";
  plot.x_label = axis_label(objectives[a]);
  plot.y_label = axis_label(objectives[b]);
  PlotSeries bars = interval_bars(front, a, b);
  if (!bars.x.empty()) plot.series.push_back(std::move(bars));
  if (objectives.size() == 2) plot.series.push_back(steps(front));
  PlotSeries all = points(front, a, b, "");
  all.label = "designs on the front";
  all.color = 0;
  plot.series.push_back(std::move(all));
  if (advice.recommended) {
    const std::string& id = advice.recommended->design.id;
    PlotSeries chosen = points(front, a, b, id);
    chosen.label = "recommended: " + id;
    chosen.color = 1;
    if (!chosen.x.empty()) plot.series.push_back(std::move(chosen));
  }
  draw_line_plot(file, plot);
}

void draw_progress(const std::filesystem::path& file, const Recommendation& advice) {
  PlotSeries line;
  for (const study::FrontEntry& entry : advice.progress->history) {
    if (!line.y.empty()) {  // it jumps when a design is known, and stays in between
      line.x.push_back(entry.evaluations);
      line.y.push_back(line.y.back());
    }
    line.x.push_back(entry.evaluations);
    line.y.push_back(entry.hypervolume);
  }
  if (line.x.size() < 2) line.style = SeriesStyle::markers;
  LinePlot plot;
  plot.title = advice.study.spec.name + ": the search's progress";
  plot.x_label = "designs evaluated";
  plot.y_label = "dominated hypervolume";
  plot.series.push_back(std::move(line));
  draw_line_plot(file, plot);
}

}  // namespace

std::vector<std::string> draw_study_plots(const std::filesystem::path& folder,
                                          const Recommendation& advice) {
  std::vector<std::string> files;
  const std::size_t n = advice.study.objectives.size();
  if (n > 1 && advice.front.size() > 1) {
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        files.push_back(a == 0 && b == 1 ? "front.png"
                                         : fmt::format("front-{}-{}.png", a + 1, b + 1));
        draw_front(folder / files.back(), advice, a, b);
      }
    }
  }
  if (advice.progress && !advice.progress->history.empty()) {
    files.push_back("hypervolume.png");
    draw_progress(folder / files.back(), advice);
  }
  return files;
}

}  // namespace parapet::reports
