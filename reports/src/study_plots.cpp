#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "markdown.hpp"
#include "parapet/reports/line_plot.hpp"
#include "parapet/reports/recommendation.hpp"
#include "recommendation_parts.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

constexpr double gap = std::numeric_limits<double>::quiet_NaN();  // interrupts a line

std::optional<double> number(const Json& objective, const char* key) {
  return value_of(objective[key]);
}

/// The surrogate's estimate; the value itself of a formula, which is known exactly.
std::optional<double> middle(const Json& objective) {
  return number(objective, objective.contains("expression") ? "value" : "estimate");
}

/// Bars from the lower to the upper end of the surrogate's interval, across the estimate.
PlotSeries interval_bars(const Json& front, std::size_t a, std::size_t b) {
  PlotSeries bars{.label = "surrogate, 95 % interval", .x = {}, .y = {}, .color = 5};
  const auto add = [&](double x0, double y0, double x1, double y1) {
    bars.x.insert(bars.x.end(), {x0, x1, gap});
    bars.y.insert(bars.y.end(), {y0, y1, gap});
  };
  for (const Json& design : front) {
    const Json &one = design["objectives"][a], &other = design["objectives"][b];
    const auto x = middle(one), y = middle(other);
    if (!x || !y) continue;
    const auto x0 = number(one, "lower_95"), x1 = number(one, "upper_95");
    const auto y0 = number(other, "lower_95"), y1 = number(other, "upper_95");
    if (x0 && x1) add(*x0, *y, *x1, *y);
    if (y0 && y1) add(*x, *y0, *x, *y1);
  }
  return bars;
}

PlotSeries points(const Json& front, std::size_t a, std::size_t b, const std::string& only_id) {
  PlotSeries series;
  series.style = SeriesStyle::markers;
  for (const Json& design : front) {
    if (!only_id.empty() && text_of(design["id"]) != only_id) continue;
    series.x.push_back(number(design["objectives"][a], "value").value_or(gap));
    series.y.push_back(number(design["objectives"][b], "value").value_or(gap));
  }
  return series;
}

/// What the front dominates is bounded by steps; with more than two objectives a projection has
/// none.
PlotSeries steps(const Json& front) {
  PlotSeries line{.label = "", .x = {}, .y = {}, .style = SeriesStyle::dashed, .color = 0};
  std::vector<std::pair<double, double>> at;
  for (const Json& design : front) {
    const auto x = number(design["objectives"][0], "value");
    const auto y = number(design["objectives"][1], "value");
    if (x && y) at.emplace_back(*x, *y);
  }
  std::ranges::sort(at);
  const bool more_is_better = text_of(front[0]["objectives"][0]["goal"]) == "maximize";
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

std::string axis_label(const Json& objective) {
  const char* better =
      text_of(objective["goal"]) == "maximize" ? "more is better" : "less is better";
  return fmt::format("{} ({})", objective_label(objective), better);
}

void draw_front(const std::filesystem::path& file, const Json& json, std::size_t a, std::size_t b) {
  const Json& front = json["front"];
  LinePlot plot;
  plot.title = text_of(json["study"]["name"]) + ": the front";
  plot.x_label = axis_label(front[0]["objectives"][a]);
  plot.y_label = axis_label(front[0]["objectives"][b]);
  PlotSeries bars = interval_bars(front, a, b);
  if (!bars.x.empty()) plot.series.push_back(std::move(bars));
  if (front[0]["objectives"].size() == 2) plot.series.push_back(steps(front));
  PlotSeries all = points(front, a, b, "");
  all.label = "designs on the front";
  all.color = 0;
  plot.series.push_back(std::move(all));
  if (json["feasible"].get<bool>()) {
    const std::string id = text_of(json["recommended"]["id"]);
    PlotSeries chosen = points(front, a, b, id);
    chosen.label = "recommended: " + id;
    chosen.color = 1;
    if (!chosen.x.empty()) plot.series.push_back(std::move(chosen));
  }
  draw_line_plot(file, plot);
}

bool draw_hypervolume(const std::filesystem::path& file, const Json& json) {
  const Json& volume = json["hypervolume"];
  if (!volume.is_object() || volume["history"].empty()) return false;
  PlotSeries line;
  for (const Json& entry : volume["history"]) {
    if (!line.y.empty()) {  // it jumps when a design is known, and stays in between
      line.x.push_back(value_of(entry["evaluations"]).value_or(gap));
      line.y.push_back(line.y.back());
    }
    line.x.push_back(value_of(entry["evaluations"]).value_or(gap));
    line.y.push_back(value_of(entry["hypervolume"]).value_or(gap));
  }
  if (line.x.size() < 2) line.style = SeriesStyle::markers;
  LinePlot plot;
  plot.title = text_of(json["study"]["name"]) + ": the search's progress";
  plot.x_label = "designs evaluated";
  plot.y_label = "dominated hypervolume";
  plot.series.push_back(std::move(line));
  draw_line_plot(file, plot);
  return true;
}

}  // namespace

std::vector<std::string> draw_study_plots(const std::filesystem::path& study_dir,
                                          const Json& json) {
  std::vector<std::string> files;
  const std::size_t n = json["study"]["objectives"].size();
  if (n > 1 && json["front"].size() > 1) {
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        files.push_back(a == 0 && b == 1 ? "front.png"
                                         : fmt::format("front-{}-{}.png", a + 1, b + 1));
        draw_front(study_dir / files.back(), json, a, b);
      }
    }
  }
  if (n > 1 && draw_hypervolume(study_dir / "hypervolume.png", json)) {
    files.push_back("hypervolume.png");
  }
  return files;
}

}  // namespace parapet::reports
