#include "parapet/reports/line_plot.hpp"

#include <cmath>
#include <stdexcept>

#include "parapet/reports/plot_axes.hpp"
#include "picture_pixels.hpp"
#include "scratch_folder.hpp"

namespace parapet::reports {
namespace {

constexpr std::uint32_t first_color = 0x0072B2;

TEST(NiceTicks, AreRoundNumbersInTheRange) {
  const Ticks ticks = nice_ticks(-0.03, 0.62, 6);
  ASSERT_EQ(ticks.values.size(), 7U);
  EXPECT_DOUBLE_EQ(ticks.step, 0.1);
  EXPECT_DOUBLE_EQ(ticks.values.front(), 0.0);
  EXPECT_EQ(ticks.labels.front(), "0.0");
  EXPECT_EQ(ticks.labels.back(), "0.6");
}

TEST(NiceTicks, KeepDecimalsAndSigns) {
  EXPECT_EQ(nice_ticks(-0.04, 0.0, 4).labels.front(), "−0.04");
  EXPECT_EQ(nice_ticks(0.0, 5000.0, 5).labels.back(), "5000");
  EXPECT_EQ(nice_ticks(1.2e6, 1.4e6, 4).labels.front(), "1.20e6");
}

TEST(NiceTicks, IncludeTheEndsOfTheRange) {
  const Ticks ticks = nice_ticks(0.0, 0.3, 3);
  EXPECT_DOUBLE_EQ(ticks.values.back(), 0.3);
}

TEST(RoundUp, GivesTheNextRoundNumber) {
  EXPECT_DOUBLE_EQ(round_up(2.31), 2.5);
  EXPECT_DOUBLE_EQ(round_up(2.5), 2.5);
  EXPECT_DOUBLE_EQ(round_up(8.5), 10.0);
  EXPECT_DOUBLE_EQ(round_up(0.0111), 0.015);
}

/// y = 0 from x = 0 to 1, missing between 0.3 and 0.7.
LinePlot interrupted_line() {
  LinePlot plot;
  plot.x_label = "time [s]";
  plot.y_label = "depth [m]";
  PlotSeries series{"depth", {}, {}, SeriesStyle::line, {}};
  for (int k = 0; k <= 100; ++k) {
    series.x.push_back(0.01 * k);
    series.y.push_back(k > 30 && k < 70 ? std::nan("") : 0.0);
  }
  series.label.clear();
  plot.series.push_back(series);
  plot.x_limits = {0.0, 1.0};
  plot.y_limits = {-1.0, 1.0};
  return plot;
}

using LinePlotTest = ScratchFolder;

TEST_F(LinePlotTest, ValuesThatAreNotFiniteInterruptTheLine) {
  draw_line_plot(folder_ / "plot.png", interrupted_line());
  const PicturePixels picture(folder_ / "plot.png");
  ASSERT_EQ(picture.width(), 1000);
  ASSERT_EQ(picture.height(), 620);
  EXPECT_GT(picture.patch(first_color, 0, 350).count, 100);
  EXPECT_EQ(picture.patch(first_color, 420, 640).count, 0);
  EXPECT_GT(picture.patch(first_color, 720, 1000).count, 100);
}

TEST_F(LinePlotTest, TheLegendAvoidsTheCurve) {
  LinePlot plot = interrupted_line();
  plot.series.front().label = "depth";
  draw_line_plot(folder_ / "with.png", plot);
  draw_line_plot(folder_ / "without.png", interrupted_line());
  const int with = PicturePixels(folder_ / "with.png").patch(first_color, 0, 1000).count;
  const int without = PicturePixels(folder_ / "without.png").patch(first_color, 0, 1000).count;
  EXPECT_GT(with, without) << "the curve is whole and the legend shows its line";
}

TEST_F(LinePlotTest, DrawsBandsMarkersAndFlatData) {
  LinePlot plot;
  plot.series.push_back({"flat", {0.0, 1.0}, {5.0, 5.0}, SeriesStyle::line_and_markers, {}});
  plot.bands.push_back({"range", {0.0, 1.0}, {4.0, 4.5}, {6.0, 5.5}, 2});
  draw_line_plot(folder_ / "plot.svg", plot);
  EXPECT_NE(content(folder_ / "plot.svg").find("</svg>"), std::string::npos);
  plot.bands.clear();
  draw_line_plot(folder_ / "plot.png", plot);
  EXPECT_GT(PicturePixels(folder_ / "plot.png").patch(first_color, 0, 1000).count, 300);
}

TEST_F(LinePlotTest, RefusesWhatCannotBeDrawn) {
  LinePlot nothing;
  EXPECT_THROW(draw_line_plot(folder_ / "plot.png", nothing), std::invalid_argument);
  LinePlot uneven = interrupted_line();
  uneven.series.front().y.pop_back();
  EXPECT_THROW(draw_line_plot(folder_ / "plot.png", uneven), std::invalid_argument);
  LinePlot turned = interrupted_line();
  turned.x_limits = {1.0, 0.0};
  EXPECT_THROW(draw_line_plot(folder_ / "plot.png", turned), std::invalid_argument);
  EXPECT_EQ(files(), 0U);
}

}  // namespace
}  // namespace parapet::reports
