/// The frame of a line plot and the legend that goes into it or beside it.
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "parapet/reports/canvas.hpp"
#include "parapet/reports/line_plot.hpp"

namespace parapet::reports {

constexpr double band_alpha = 0.22;

struct Range {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (!std::isfinite(value)) return;
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
  double width() const { return upper - lower; }
};

/// Where data lie on the page.
struct PlotFrame {
  PixelBox box;
  Range x, y;

  Pixel at(double px, double py) const {
    return {box.left + (px - x.lower) / x.width() * box.width,
            box.bottom() - (py - y.lower) / y.width() * box.height};
  }
};

/// One line of the legend.
struct LegendEntry {
  std::string label;
  Color color;
  SeriesStyle style;
  bool band;
};

inline bool finite(double x, double y) {
  return std::isfinite(x) && std::isfinite(y);
}

bool has_line(SeriesStyle style);
bool has_markers(SeriesStyle style);
Pen line_pen(SeriesStyle style, double font, const Color& color);
void draw_marker(Canvas& canvas, Pixel at, double font, const Color& color);

/// Every series and band with a label.
std::vector<LegendEntry> legend_entries(const LinePlot& plot);

/// A box at the page's origin that holds the entries [px].
PixelBox legend_size(Canvas& canvas, const std::vector<LegendEntry>& entries, double font);

/// The corner of the frame in which the legend hides least, and how much it hides there: length of
/// curve and number of points [px].
std::pair<PixelBox, double> best_corner(const LinePlot& plot, const PlotFrame& frame,
                                        PixelBox legend, double font);

void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, const PixelBox& box,
                 double font);

}  // namespace parapet::reports
