#include "parapet/reports/line_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "line_colors.hpp"
#include "parapet/reports/color_map.hpp"
#include "parapet/reports/plot_axes.hpp"
#include "plot_legend.hpp"

namespace parapet::reports {
namespace {

constexpr Color grid_color{0.90, 0.90, 0.91, 1.0};

void check(const LinePlot& plot) {
  for (const PlotSeries& series : plot.series) {
    if (series.x.size() != series.y.size()) {
      throw std::invalid_argument(fmt::format("series \"{}\": {} values of x but {} of y",
                                              series.label, series.x.size(), series.y.size()));
    }
  }
  for (const PlotBand& band : plot.bands) {
    if (band.x.size() != band.lower.size() || band.x.size() != band.upper.size()) {
      throw std::invalid_argument(fmt::format("band \"{}\": arrays of unequal length", band.label));
    }
  }
}

/// Limits as asked, or those of the data with a margin; a flat range is opened.
Range limits(Range data, const std::optional<std::pair<double, double>>& asked, double margin,
             const char* axis) {
  if (asked) {
    if (!finite(asked->first, asked->second) || !(asked->first < asked->second)) {
      throw std::invalid_argument(fmt::format("limits of {}: {} to {}; allowed: lower below upper",
                                              axis, asked->first, asked->second));
    }
    return {asked->first, asked->second};
  }
  if (!(data.lower <= data.upper)) {
    throw std::invalid_argument("a plot needs at least one finite point");
  }
  if (data.width() <= 1e-12 * std::max(std::abs(data.lower), std::abs(data.upper))) {
    const double half = data.lower == 0.0 ? 1.0 : 0.1 * std::abs(data.lower);
    return {data.lower - half, data.upper + half};
  }
  const double pad = margin * data.width();
  return {data.lower - pad, data.upper + pad};
}

std::pair<Range, Range> data_ranges(const LinePlot& plot) {
  Range x, y;
  for (const PlotSeries& series : plot.series) {
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      if (!finite(series.x[k], series.y[k])) continue;
      x.include(series.x[k]);
      y.include(series.y[k]);
    }
  }
  for (const PlotBand& band : plot.bands) {
    for (std::size_t k = 0; k < band.x.size(); ++k) {
      x.include(band.x[k]);
      y.include(band.lower[k]);
      y.include(band.upper[k]);
    }
  }
  const bool markers = std::ranges::any_of(
      plot.series, [](const PlotSeries& series) { return has_markers(series.style); });
  return {limits(x, plot.x_limits, markers ? 0.02 : 0.0, "x"), limits(y, plot.y_limits, 0.05, "y")};
}

void draw_axes(Canvas& canvas, const LinePlot& plot, const PlotFrame& frame, double font) {
  const Pen pen{frame_color, 0.07 * font, {}};
  const Pen grid{grid_color, 0.07 * font, {}};
  const Ticks x = nice_ticks(frame.x.lower, frame.x.upper,
                             std::max(2, static_cast<int>(frame.box.width / (6.0 * font))));
  const TextStyle x_style{0.9 * font, ink, false, AlignX::center, AlignY::top, 0.0};
  for (std::size_t k = 0; k < x.values.size(); ++k) {
    const Pixel at = frame.at(x.values[k], frame.y.lower);
    canvas.polyline({at, {at.x, frame.box.top}}, grid);
    canvas.polyline({at, {at.x, at.y + 0.3 * font}}, pen);
    canvas.text({at.x, at.y + 0.6 * font}, x.labels[k], x_style);
  }
  const Ticks y = nice_ticks(frame.y.lower, frame.y.upper,
                             std::max(2, static_cast<int>(frame.box.height / (4.0 * font))));
  const TextStyle y_style{0.9 * font, ink, false, AlignX::right, AlignY::middle, 0.0};
  for (std::size_t k = 0; k < y.values.size(); ++k) {
    const Pixel at = frame.at(frame.x.lower, y.values[k]);
    canvas.polyline({at, {frame.box.right(), at.y}}, grid);
    canvas.polyline({at, {at.x - 0.3 * font, at.y}}, pen);
    canvas.text({at.x - 0.5 * font, at.y}, y.labels[k], y_style);
  }
  canvas.text({frame.box.left + 0.5 * frame.box.width, plot.height_px - 0.6 * font}, plot.x_label,
              {font, ink, false, AlignX::center, AlignY::bottom, 0.0});
  canvas.text({0.9 * font, frame.box.top + 0.5 * frame.box.height}, plot.y_label,
              {font, ink, false, AlignX::center, AlignY::middle, -std::numbers::pi / 2.0});
  canvas.text({frame.box.left, 1.4 * font}, plot.title, {1.2 * font, ink, true});
}

void draw_band(Canvas& canvas, const PlotFrame& frame, const PlotBand& band, Color color) {
  std::vector<Pixel> outline, back;
  for (std::size_t k = 0; k < band.x.size(); ++k) {
    if (!finite(band.x[k], band.lower[k]) || !std::isfinite(band.upper[k])) continue;
    outline.push_back(frame.at(band.x[k], band.lower[k]));
    back.push_back(frame.at(band.x[k], band.upper[k]));
  }
  outline.insert(outline.end(), back.rbegin(), back.rend());
  color.alpha = band_alpha;
  canvas.fill_polygon(outline, color);
}

void draw_series(Canvas& canvas, const PlotFrame& frame, const PlotSeries& series, double font,
                 const Color& color) {
  std::vector<Pixel> run;
  const Pen pen = line_pen(series.style, font, color);
  for (std::size_t k = 0; k <= series.x.size(); ++k) {
    if (k < series.x.size() && finite(series.x[k], series.y[k])) {
      run.push_back(frame.at(series.x[k], series.y[k]));
      continue;
    }
    if (has_line(series.style) && run.size() > 1) canvas.polyline(run, pen);
    if (has_markers(series.style)) {
      for (const Pixel& at : run) draw_marker(canvas, at, font, color);
    }
    run.clear();
  }
}

/// Widest label of the y axis, which decides the left margin [px].
double tick_label_width(Canvas& canvas, const Range& y, double height, double font) {
  double width = 0.0;
  const int wanted = std::max(2, static_cast<int>(height / (4.0 * font)));
  for (const std::string& label : nice_ticks(y.lower, y.upper, wanted).labels) {
    width = std::max(width, canvas.text_width(label, {0.9 * font, ink}));
  }
  return width;
}

}  // namespace

void draw_line_plot(const std::filesystem::path& path, const LinePlot& plot) {
  check(plot);
  Canvas canvas(path, plot.width_px, plot.height_px);
  const double font = std::clamp(plot.width_px / 58.0, 9.0, 30.0);
  PlotFrame frame;
  std::tie(frame.x, frame.y) = data_ranges(plot);
  const double top = plot.title.empty() ? 0.9 * font : 2.7 * font;
  const double height = plot.height_px - top - 3.7 * font;
  const double left = 2.6 * font + tick_label_width(canvas, frame.y, height, font);
  frame.box = {left, top, plot.width_px - left - 1.4 * font, height};

  const std::vector<LegendEntry> entries = legend_entries(plot);
  PixelBox legend = legend_size(canvas, entries, font);
  if (!entries.empty()) {
    const auto [corner, amount] = best_corner(plot, frame, legend, font);
    const double narrower = frame.box.width - legend.width - 0.4 * font;
    if (amount > 0.0 && narrower > 0.45 * plot.width_px) {  // beside the frame it hides nothing
      frame.box.width = narrower;
      legend.left = frame.box.right() + 0.8 * font;
      legend.top = frame.box.top;
    } else {
      legend = corner;
    }
  }
  draw_axes(canvas, plot, frame, font);
  canvas.clip(frame.box);
  for (std::size_t k = 0; k < plot.bands.size(); ++k) {
    draw_band(canvas, frame, plot.bands[k],
              palette_color(plot.bands[k].color.value_or(static_cast<int>(k))));
  }
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    draw_series(canvas, frame, plot.series[k], font,
                palette_color(plot.series[k].color.value_or(static_cast<int>(k))));
  }
  canvas.unclip();
  canvas.outline_box(frame.box, {frame_color, 0.07 * font, {}});
  if (!entries.empty()) draw_legend(canvas, entries, legend, font);
  canvas.save();
}

}  // namespace parapet::reports
