#include "plot_legend.hpp"

#include <algorithm>

#include "line_colors.hpp"
#include "parapet/reports/color_map.hpp"

namespace parapet::reports {
namespace {

/// Length of curve and number of points that a legend there would hide [px].
double hidden(const LinePlot& plot, const PlotFrame& frame, const PixelBox& legend) {
  const auto inside = [&](Pixel at) {
    return at.x > legend.left && at.x < legend.right() && at.y > legend.top &&
           at.y < legend.bottom();
  };
  double amount = 0.0;
  const auto walk = [&](Pixel from, Pixel to) {
    const int pieces =
        std::clamp(static_cast<int>(std::hypot(to.x - from.x, to.y - from.y)), 1, 4000);
    for (int k = 0; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      if (inside({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)})) amount += 1.0;
    }
  };
  const auto walk_all = [&](const std::vector<double>& x, const std::vector<double>& y) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (!finite(x[k], y[k])) continue;
      const bool joined = k > 0 && finite(x[k - 1], y[k - 1]);
      const Pixel at = frame.at(x[k], y[k]);
      walk(joined ? frame.at(x[k - 1], y[k - 1]) : at, at);
    }
  };
  for (const PlotSeries& series : plot.series) walk_all(series.x, series.y);
  for (const PlotBand& band : plot.bands) {
    walk_all(band.x, band.lower);
    walk_all(band.x, band.upper);
  }
  return amount;
}

}  // namespace

bool has_line(SeriesStyle style) {
  return style != SeriesStyle::markers;
}

bool has_markers(SeriesStyle style) {
  return style == SeriesStyle::markers || style == SeriesStyle::line_and_markers;
}

void draw_marker(Canvas& canvas, Pixel at, double font, const Color& color) {
  canvas.disc(at, 0.32 * font, {1.0, 1.0, 1.0, 1.0});
  canvas.disc(at, 0.26 * font, color);
}

Pen line_pen(SeriesStyle style, double font, const Color& color) {
  Pen pen{color, 0.13 * font, {}};
  if (style == SeriesStyle::dashed) pen.dashes = {0.5 * font, 0.3 * font};
  return pen;
}

std::vector<LegendEntry> legend_entries(const LinePlot& plot) {
  std::vector<LegendEntry> entries;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    if (series.label.empty()) continue;
    entries.push_back({series.label, palette_color(series.color.value_or(static_cast<int>(k))),
                       series.style, false});
  }
  for (std::size_t k = 0; k < plot.bands.size(); ++k) {
    const PlotBand& band = plot.bands[k];
    if (band.label.empty()) continue;
    Color color = palette_color(band.color.value_or(static_cast<int>(k)));
    color.alpha = 1.6 * band_alpha;
    entries.push_back({band.label, color, SeriesStyle::line, true});
  }
  return entries;
}

PixelBox legend_size(Canvas& canvas, const std::vector<LegendEntry>& entries, double font) {
  double width = 0.0;
  for (const LegendEntry& entry : entries) {
    width = std::max(width, canvas.text_width(entry.label, {0.9 * font, ink}));
  }
  return {0.0, 0.0, width + 3.6 * font, (1.4 * static_cast<double>(entries.size()) + 0.5) * font};
}

std::pair<PixelBox, double> best_corner(const LinePlot& plot, const PlotFrame& frame,
                                        PixelBox legend, double font) {
  const double pad = 0.6 * font;
  std::pair<PixelBox, double> best{legend, std::numeric_limits<double>::infinity()};
  for (const double left : {frame.box.right() - pad - legend.width, frame.box.left + pad}) {
    for (const double top : {frame.box.top + pad, frame.box.bottom() - pad - legend.height}) {
      legend.left = left;
      legend.top = top;
      const double amount = hidden(plot, frame, legend);
      if (amount < best.second) best = {legend, amount};
    }
  }
  return best;
}

void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, const PixelBox& box,
                 double font) {
  canvas.fill_box(box, {1.0, 1.0, 1.0, 0.85});
  canvas.outline_box(box, {{0.8, 0.8, 0.82, 1.0}, 0.06 * font, {}});
  double y = box.top + 0.95 * font;
  for (const LegendEntry& entry : entries) {
    const double from = box.left + 0.6 * font;
    const double to = from + 2.0 * font;
    if (entry.band) {
      canvas.fill_box({from, y - 0.4 * font, to - from, 0.8 * font}, entry.color);
    } else {
      if (has_line(entry.style)) {
        canvas.polyline({{from, y}, {to, y}}, line_pen(entry.style, font, entry.color));
      }
      if (has_markers(entry.style)) {
        draw_marker(canvas, {0.5 * (from + to), y}, font, entry.color);
      }
    }
    canvas.text({to + 0.5 * font, y}, entry.label, {0.9 * font, ink});
    y += 1.4 * font;
  }
}

}  // namespace parapet::reports
