/// A small line and scatter plot for time series and validation figures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parapet::reports {

/// How a curve is drawn.
enum class SeriesStyle { line, dashed, markers, line_and_markers };

/// One curve; points where y is not finite interrupt it.
struct PlotSeries {
  std::string label;         ///< in the legend; empty for none
  std::vector<double> x, y;  ///< [n]
  SeriesStyle style = SeriesStyle::line;
  std::optional<int> color;  ///< place in the palette, so that curves of several plots can agree
};

/// A shaded range lower..upper over x, for example percentiles of a measurement.
struct PlotBand {
  std::string label;
  std::vector<double> x, lower, upper;  ///< [n]
  std::optional<int> color;
};

/// Curves and bands over one pair of axes.
struct LinePlot {
  std::string title;
  std::string x_label, y_label;  ///< with the unit, for example "time [s]"
  std::vector<PlotSeries> series;
  std::vector<PlotBand> bands;
  std::optional<std::pair<double, double>> x_limits, y_limits;  ///< default: from the data
  int width_px = 1000;
  int height_px = 620;
};

/// @param path ends in .png or .svg, which decides the format.
/// @throws std::invalid_argument when there is nothing finite to draw, arrays differ in length, or
///         for another ending.
/// @throws FileError when the file cannot be written.
void draw_line_plot(const std::filesystem::path& path, const LinePlot& plot);

}  // namespace parapet::reports
