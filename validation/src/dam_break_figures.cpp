#include <fmt/format.h>

#include <algorithm>

#include "dam_break_groups.hpp"
#include "parapet/reports/line_plot.hpp"

namespace parapet::validation {

void draw_depths(CaseRun& run, const Group& finest, const Lobovsky& m) {
  reports::LinePlot p;
  p.title = fmt::format("Depths at the four gauges, {}; bands: measured", finest.name);
  p.x_label = "t* = t sqrt(g/H)";
  p.y_label = "h/H";
  for (std::size_t g = 0; g < 4; ++g) {
    const MeasuredBand& band = m.levels[g].depth;
    std::vector<double> low = band.low, high = band.high;
    for (std::size_t k = 0; k < low.size(); ++k) {  // so that equal runs can be seen
      low[k] -= 0.006;
      high[k] += 0.006;
    }
    const int color = static_cast<int>(g);
    p.bands.push_back({"", band.t, low, high, color});
    p.series.push_back({fmt::format("H{}", g + 1), finest.whole().depth[g].t,
                        finest.whole().depth[g].value, reports::SeriesStyle::line, color});
  }
  p.x_limits = {0.0, 8.0};
  p.y_limits = {0.0, 1.05};
  p.width_px = 900;
  draw_line_plot(run.figure("depths.png"), p);
}

void draw_pressures(CaseRun& run, const std::vector<Group>& spacings, const Group& no_slip,
                    const Lobovsky& m) {
  reports::LinePlot p;
  p.title = "Pressure at sensor 2 (15 mm), means over 0.1 in t*";
  p.x_label = "t* = t sqrt(g/H), on the pressure's arrival";
  p.y_label = "p/(rho g H)";
  p.bands.push_back({"measured, 2.5 to 97.5 %", m.sensor_2.t, m.sensor_2.low, m.sensor_2.high, 0});
  p.series.push_back(
      {"measured, median", m.sensor_2.t, m.sensor_2.middle, reports::SeriesStyle::dashed, 0});
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    p.series.push_back({spacings[k].name, m.sensor_2.t, sensor_2(spacings[k].whole(), m),
                        reports::SeriesStyle::line, static_cast<int>(k) + 1});
  }
  p.series.push_back({no_slip.name, m.sensor_2.t, sensor_2(no_slip.whole(), m),
                      reports::SeriesStyle::dashed, static_cast<int>(spacings.size()) + 1});
  p.x_limits = {2.3, 7.0};
  p.y_limits = {0.0, 3.5};
  p.width_px = 900;
  draw_line_plot(run.figure("sensor_2.png"), p);

  reports::LinePlot one;
  one.title = "Pressure at sensor 1 (3 mm), means over 7 ms";
  one.x_label = p.x_label;
  one.y_label = p.y_label;
  one.series.push_back(
      {"measured, one run", m.sensor_1_t, m.sensor_1_p, reports::SeriesStyle::line, 0});
  const Group& finest = spacings.back();
  const double half = 0.5 * rise_window(m, finest.dam.depth);
  for (std::size_t k = 0; k < std::min<std::size_t>(finest.runs.size(), 2); ++k) {
    const DamBreakRecord& r = finest.runs[k];
    reports::PlotSeries s{fmt::format("{}, run {}", finest.name, k + 1),
                          {},
                          {},
                          reports::SeriesStyle::line,
                          static_cast<int>(k) + 1};
    for (double t = 2.3; t < 4.0; t += 0.01) {
      s.x.push_back(t);
      s.y.push_back(r.pressure[0].mean_around(t - m.arrival_at_wall + r.arrival, half));
    }
    one.series.push_back(s);
  }
  one.x_limits = {2.3, 4.0};
  one.y_limits = {0.0, 5.0};
  one.width_px = 900;
  one.height_px = 480;
  draw_line_plot(run.figure("sensor_1.png"), one);
}

void draw_flow(CaseRun& run, const Group& g) {
  const DamBreakRecord& r = g.whole();
  ParticlePicture picture;
  picture.title = fmt::format("Dam break, {}: speed", g.name);
  picture.quantity = fmt::format("speed [m/s]");
  picture.low = 0.0;
  picture.high = 3.5;
  picture.spacing = g.dam.spacing;
  picture.walls = r.flow->solids().faces;
  picture.window_from = {-0.02, -0.02};
  picture.window_to = {1.63, 0.62};
  picture.panels = r.speed;
  picture.columns = 2;
  picture.width_px = 900;
  draw(run, "flow.png", picture);
}

}  // namespace parapet::validation
